Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset [_Factor], [_Units]
        }
    }
}

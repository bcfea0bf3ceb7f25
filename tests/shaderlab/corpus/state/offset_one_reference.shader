Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset 0, [_Units]
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset [_F], -1
        }
    }
}

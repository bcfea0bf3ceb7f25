Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask [_ColorMask]
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
            ColorMask RGB
        }
    }
    Fallback "X"
}

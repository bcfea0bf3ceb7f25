Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RGB 9
        }
    }
}

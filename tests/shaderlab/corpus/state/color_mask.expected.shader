Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RGB
        }
    }
}

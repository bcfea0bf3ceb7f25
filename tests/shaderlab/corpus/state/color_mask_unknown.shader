Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RGX
        }
    }
}

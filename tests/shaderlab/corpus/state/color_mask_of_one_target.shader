Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RG 3
        }
    }
}

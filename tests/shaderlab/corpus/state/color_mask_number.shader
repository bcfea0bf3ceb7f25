Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask 7
            ZWrite Of
        }
    }
}

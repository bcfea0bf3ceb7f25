Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask 0
        }
    }
}

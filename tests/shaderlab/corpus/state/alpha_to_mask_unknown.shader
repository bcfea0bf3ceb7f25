Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaToMask RGB
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaToMask True
        }
    }
}

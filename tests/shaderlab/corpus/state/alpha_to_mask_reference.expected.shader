Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaToMask [_A]
        }
    }
}

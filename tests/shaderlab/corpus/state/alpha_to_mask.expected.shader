Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaToMask On
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
        }
        Tags { "Queue" = "Overlay" }
        Pass
        {
        }
    }
}

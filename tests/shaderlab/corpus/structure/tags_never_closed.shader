Shader "T"
{
    SubShader
    {
        Tags { "Queue" = "Overlay"
        Pass
        {
        }
    }
}

Shader "T"
{
    SubShader
    {
        Tags { "Queue" = "Overlay" "A" = "1" }
    }
}

Shader "T"
{
    SubShader
    {
        Tags { "Queue" = "Transparent-10" }
    }
}

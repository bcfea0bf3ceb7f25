Shader "T"
{
    SubShader
    {
        Tags { "Queue" = }
    }
}

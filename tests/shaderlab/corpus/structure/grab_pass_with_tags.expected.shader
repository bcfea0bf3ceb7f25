Shader "T"
{
    SubShader
    {
        GrabPass { "_G" Tags { "LightMode" = "Always" } }
    }
}

Shader "T"
{
    SubShader
    {
        GrabPass { Tags { "LightMode" = "Always" } "_G" }
    }
}

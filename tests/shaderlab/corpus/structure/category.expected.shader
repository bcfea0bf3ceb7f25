Shader "T"
{
    SubShader
    {
        Tags { "Queue" = "Transparent" }
        Pass
        {
            Cull Front
            Blend SrcAlpha One
        }
    }
    SubShader
    {
        Tags { "Queue" = "Transparent" }
        Pass
        {
            Cull Off
            Blend SrcAlpha One
        }
    }
}

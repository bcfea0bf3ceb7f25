Shader "T"
{
    SubShader
    {
        Tags { "RenderType"="Opaque" "Queue" = "Geometry+1" }
    }
}

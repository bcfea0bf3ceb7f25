Shader "T"
{
    SubShader
    {
        Tags { "RenderType" = Opaque }
    }
}

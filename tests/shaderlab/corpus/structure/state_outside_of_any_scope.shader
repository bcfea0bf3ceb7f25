Shader "T"
{
    Cull Off
    SubShader
    {
    }
}

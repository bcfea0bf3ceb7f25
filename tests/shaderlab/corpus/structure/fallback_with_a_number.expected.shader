Shader "T"
{
    Fallback "Diffuse"
}

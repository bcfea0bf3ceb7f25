Shader "T"
{
    Fallback "Diffuse", 1
}

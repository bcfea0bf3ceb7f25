Shader "T"
{
    Fallback "A"
    Fallback "B"
}

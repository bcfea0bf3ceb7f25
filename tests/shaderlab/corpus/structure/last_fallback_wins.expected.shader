Shader "T"
{
    Fallback "B"
}

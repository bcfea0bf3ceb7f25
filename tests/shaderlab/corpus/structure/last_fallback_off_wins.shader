Shader "T"
{
    Fallback "A"
    Fallback Off
}

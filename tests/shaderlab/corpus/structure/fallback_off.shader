Shader "T"
{
    Fallback Off
}

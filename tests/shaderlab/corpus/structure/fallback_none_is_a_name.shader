Shader "T"
{
    Fallback "None"
}

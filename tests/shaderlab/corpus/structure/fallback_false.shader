Shader "T"
{
    Fallback False
}

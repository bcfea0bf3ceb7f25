Shader "T"
{
    Fallback "Universal Render Pipeline/Lit"
}

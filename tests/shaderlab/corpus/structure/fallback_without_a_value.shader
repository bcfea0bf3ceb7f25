Shader "T"
{
    Fallback
    SubShader
    {
    }
}

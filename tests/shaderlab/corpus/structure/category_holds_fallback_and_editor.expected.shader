Shader "T"
{
    SubShader
    {
    }
    Fallback "F"
    CustomEditor "E"
    Dependency "A" = "B"
}

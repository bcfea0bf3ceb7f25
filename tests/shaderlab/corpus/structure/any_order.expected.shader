Shader "T"
{
    Properties
    {
        _A("a", Float) = 1
    }
    SubShader
    {
    }
    Fallback "F"
    CustomEditor "E"
    Dependency "A" = "B"
}

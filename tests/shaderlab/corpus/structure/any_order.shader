Shader "T"
{
    CustomEditor "E"
    Fallback "F"
    SubShader
    {
    }
    Dependency "A" = "B"
    Properties
    {
        _A("a", Float) = 1
    }
}

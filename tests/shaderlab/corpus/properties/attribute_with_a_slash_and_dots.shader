Shader "T"
{
    Properties
    {
        [Header(v1.2 / beta...)] _A("a", Float) = 1
    }
}

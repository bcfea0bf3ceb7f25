Shader "T"
{
    Properties
    {
        _a("a", Float) = 1
        _A("A", Float) = 2
    }
}

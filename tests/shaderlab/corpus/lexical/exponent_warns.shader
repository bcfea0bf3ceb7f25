Shader "T"
{
    Properties
    {
        _A("a", Float) = 1e2
        _B("b", Float) = 25E-2
    }
}

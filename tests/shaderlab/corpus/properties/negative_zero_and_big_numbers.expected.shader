Shader "T"
{
    Properties
    {
        _A("a", Float) = 1000000
        _B("b", Float) = 0.000001
    }
}

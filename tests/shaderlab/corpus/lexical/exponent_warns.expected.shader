Shader "T"
{
    Properties
    {
        _A("a", Float) = 100
        _B("b", Float) = 0.25
    }
}

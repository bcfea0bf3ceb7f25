Shader "T"
{
    Properties
    {
        _A("a", Range(0, max)) = 1
        _B("b", Float) = x
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Range(1)) = 1
        _B("b", Float) = x
    }
}

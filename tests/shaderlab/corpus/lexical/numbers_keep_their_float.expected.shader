Shader "T"
{
    Properties
    {
        _A("a", Float) = 0.1
        _B("b", Float) = 3.1415927
        _C("c", Float) = 16777216
    }
}

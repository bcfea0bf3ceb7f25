Shader "T"
{
    Properties
    {
        _A("a", Float) = 0.1
        _B("b", Float) = 3.14159265
        _C("c", Float) = 16777217
    }
}

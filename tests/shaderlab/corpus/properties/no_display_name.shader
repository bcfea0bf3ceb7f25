Shader "T"
{
    Properties
    {
        _A(Float) = 1
        _B("b", Float) = x
    }
}

Shader "T"
{
    Properties
    {
        _A("a", 2D) = 1
        _B("b", Float) = x
    }
}

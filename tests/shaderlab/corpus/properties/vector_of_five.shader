Shader "T"
{
    Properties
    {
        _A("a", Vector) = (1, 2, 3, 4, 5)
        _B("b", Float) = x
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Color) = 1
        _B("b", Float) = x
    }
}

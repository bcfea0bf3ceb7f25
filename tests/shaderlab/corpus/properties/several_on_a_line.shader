Shader "T"
{
    Properties
    {
        _A("a", Float) = 1 _B("b", Float) = 2
    }
}

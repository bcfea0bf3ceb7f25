Shader "T"
{
    Properties
    {
        _A("a", Flaot) = 1
        _B("b", Float) = 1
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Float) = 1.5f
        _B("b", Float) = 2h
    }
}

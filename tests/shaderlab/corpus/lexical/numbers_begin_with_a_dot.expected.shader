Shader "T"
{
    Properties
    {
        _A("a", Float) = 0.5
        _B("b", Float) = -0.5
    }
}

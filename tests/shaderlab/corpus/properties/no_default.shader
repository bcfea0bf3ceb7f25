Shader "T"
{
    Properties
    {
        _A("a", Float)
        _B("b", 2D)
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Float) = 0
        _B("b", 2D) = "" {}
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Float) = .5
        _B("b", Float) = -.5
    }
}

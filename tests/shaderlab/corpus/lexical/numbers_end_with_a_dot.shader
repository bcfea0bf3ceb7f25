Shader "T"
{
    Properties
    {
        _A("a", Float) = 100.
        _B("b", Vector) = (0., 1., -2., .25)
    }
}

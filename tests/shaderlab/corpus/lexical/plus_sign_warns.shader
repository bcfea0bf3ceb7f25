Shader "T"
{
    Properties
    {
        _A("a", Float) = +2
    }
}

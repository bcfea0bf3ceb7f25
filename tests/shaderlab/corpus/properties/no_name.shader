Shader "T"
{
    Properties
    {
        ("a", Float) = 1
        _B("b", Float) = x
    }
}

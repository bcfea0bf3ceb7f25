Shader "T"
{
    Properties
    {
        _A("a", Float) = "white" {}
        _B("b", Float) = x
    }
}

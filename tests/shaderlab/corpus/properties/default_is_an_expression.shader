Shader "T"
{
    Properties
    {
        degrees("degrees", float) = pi / 180.0
        _B("b", Float) = x
    }
}

Shader "T"
{
    Properties
    {
        _A("", Float) = 1
    }
}

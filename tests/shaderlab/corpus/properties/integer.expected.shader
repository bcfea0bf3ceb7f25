Shader "T"
{
    Properties
    {
        _A("a", Integer) = -3
    }
}

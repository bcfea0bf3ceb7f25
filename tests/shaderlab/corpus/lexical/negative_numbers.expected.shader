Shader "T"
{
    Properties
    {
        _A("a", Range(-10, -0.5)) = -1
    }
}

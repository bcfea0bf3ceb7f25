Shader "T"
{
    Properties
    {
        _A("a", Range(0.0, 1.0)) = 0.5
    }
}

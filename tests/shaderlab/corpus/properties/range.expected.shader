Shader "T"
{
    Properties
    {
        _A("a", Range(0, 1)) = 0.5
    }
}

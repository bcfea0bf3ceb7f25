Shader "T"
{
    Properties
    {
        _A("a", Range(1, -1)) = 0
    }
}

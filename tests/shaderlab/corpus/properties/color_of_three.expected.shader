Shader "T"
{
    Properties
    {
        _A("a", Color) = (1, 0.5, 0, 1)
    }
}

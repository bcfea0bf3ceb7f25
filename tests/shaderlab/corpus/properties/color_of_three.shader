Shader "T"
{
    Properties
    {
        _A("a", Color) = (1, .5, 0)
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Vector) = (1, -2, 3, 4)
    }
}

Shader "T"
{
    Properties
    {
        _A("a", Int) = 1.5
    }
}

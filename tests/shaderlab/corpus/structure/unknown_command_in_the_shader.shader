Shader "T"
{
    Proprties
    {
        _A("a", Float) = 1
    }
    Fallback "F"
}

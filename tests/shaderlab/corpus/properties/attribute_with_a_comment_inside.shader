Shader "T"
{
    Properties
    {
        [Header(a // b)] _A("a", Float) = 1
    }
}

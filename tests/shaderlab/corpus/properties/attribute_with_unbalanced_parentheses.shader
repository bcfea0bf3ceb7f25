Shader "T"
{
    Properties
    {
        [Header(A (b)] _A("a", Float) = 1
        [Header)] _B("b", Float) = 1
    }
}

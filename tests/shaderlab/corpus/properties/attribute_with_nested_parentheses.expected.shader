Shader "T"
{
    Properties
    {
        [Header(Metallic (R) Detail mask (B))] _A("a", Float) = 1
    }
}

Shader "T"
{
    Properties
    {
        [Header(It's "so)] _A("a", Float) = 1
    }
}

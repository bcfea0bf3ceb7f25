Shader "T"
{
    Properties
    {
        [Space()] _A("a", Float) = 1
    }
}

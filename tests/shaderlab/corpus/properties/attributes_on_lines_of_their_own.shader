Shader "T"
{
    Properties
    {
        [Header(Base)]
        [Space(10)]

        // a comment between
        [HideInInspector]
        _A("a", Float) = 1
    }
}

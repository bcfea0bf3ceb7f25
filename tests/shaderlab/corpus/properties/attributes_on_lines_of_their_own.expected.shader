Shader "T"
{
    Properties
    {
        [Header(Base)] [Space(10)] [HideInInspector] _A("a", Float) = 1
    }
}

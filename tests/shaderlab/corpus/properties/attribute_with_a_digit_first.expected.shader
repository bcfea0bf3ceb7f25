Shader "T"
{
    Properties
    {
        [Enum(2D,0, Cubemap,1)] _A("a", Float) = 1
    }
}

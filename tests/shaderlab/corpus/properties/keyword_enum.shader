Shader "T"
{
    Properties
    {
        [KeywordEnum(6 Frames Layout, Latitude Longitude Layout)] _A("a", Float) = 1
    }
}

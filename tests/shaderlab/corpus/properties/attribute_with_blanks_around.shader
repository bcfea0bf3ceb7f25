Shader "T"
{
    Properties
    {
        [ HDR ] _A("a", Color) = (1, 1, 1, 1)
    }
}

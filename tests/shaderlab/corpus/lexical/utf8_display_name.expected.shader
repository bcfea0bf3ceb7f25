Shader "T"
{
    Properties
    {
        _A("色 — größe", Float) = 1
    }
}

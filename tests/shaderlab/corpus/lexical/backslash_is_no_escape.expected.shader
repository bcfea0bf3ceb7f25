Shader "T"
{
    Properties
    {
        _A("C:\", Float) = 1
    }
}

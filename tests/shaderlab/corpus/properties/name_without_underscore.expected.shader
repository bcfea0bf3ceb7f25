Shader "T"
{
    Properties
    {
        width("Width", Float) = 1
    }
}

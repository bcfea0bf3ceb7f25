Shader "T"
{
    Properties
    {
        _Color("ÑÕÉ«", Float) = 1
    }
}

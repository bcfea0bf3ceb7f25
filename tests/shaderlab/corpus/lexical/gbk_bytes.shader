Shader "T"
{
    Properties
    {
        // ÑÕÉ«
        _Color("ÑÕÉ«", Float) = 1
    }
}

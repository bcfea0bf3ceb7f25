Shader "T"
{
    Properties
    {
        _A ( "a" , Float ) = 1
    }
}

Shader "T"
{
    Properties
    {
        #Color2("a", Float) = 1
        C_o_l#or3("b", Float) = 2
    }
}

Shader "T"
{
    Properties
    {
        Color("a", Color) = (1, 1, 1, 1)
        Range("b", Float) = 1
        Emission("c", Float) = 2
        Pass("d", 2D) = "white" {}
        Properties("e", Float) = 0
    }
}

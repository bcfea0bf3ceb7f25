Shader "T"
{
    Properties
    {
        _A("a", 2D) = "white" {}
        _B("b", 2D) = "bump" {}
    }
}

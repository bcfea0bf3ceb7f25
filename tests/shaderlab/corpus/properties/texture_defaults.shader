Shader "T"
{
    Properties
    {
        _A("a", 2D) = "black" {}
        _B("b", 2D) = "gray" {}
        _C("c", 2D) = "grey" {}
        _D("d", 2D) = "bump" {}
        _E("e", 2D) = "red" {}
        _F("f", 2D) = "White" {}
        _G("g", 2D) = "linearGrey" {}
    }
}

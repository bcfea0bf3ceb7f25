Shader "T"
{
    Properties
    {
        _A("a", FLoat) = 1
        _B("b", range(0, 1)) = 0
        _C("c", COLOR) = (1, 1, 1, 1)
        _D("d", CUBE) = "white" {}
        _E("e", 2d) = "white" {}
    }
}

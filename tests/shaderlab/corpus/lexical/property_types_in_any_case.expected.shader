Shader "T"
{
    Properties
    {
        _A("a", Float) = 1
        _B("b", Range(0, 1)) = 0
        _C("c", Color) = (1, 1, 1, 1)
        _D("d", Cube) = "white" {}
        _E("e", 2D) = "white" {}
    }
}

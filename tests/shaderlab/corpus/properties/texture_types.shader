Shader "T"
{
    Properties
    {
        _A("a", 2D) = "white" {}
        _B("b", 2DArray) = "white" {}
        _C("c", 3D) = "white" {}
        _D("d", Cube) = "white" {}
        _E("e", CubeArray) = "white" {}
    }
}

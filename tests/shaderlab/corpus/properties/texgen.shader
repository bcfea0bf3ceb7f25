Shader "T"
{
    Properties
    {
        _A("a", Cube) = "white" { TexGen CubeReflect }
        _B("b", 2D) = "white" { TexGen SphereMap }
    }
}

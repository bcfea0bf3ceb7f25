Shader "T"
{
    Properties
    {
        _A("a", Cube) = "_Skybox" {}
        _B("b", 2D) = "(0.5, 0.0, 1.0)" {}
    }
}

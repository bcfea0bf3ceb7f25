Shader "T"
{
    Properties
    {
        _A("a", Rect) = "white" {}
        _B("b", Any) = "white" {}
    }
}

Shader "T"
{
    Properties
    {
        [HDR] [MainColor] _A("a", Color) = (1, 1, 1, 1)
        [NoScaleOffset] [Normal] _B("b", 2D) = "bump" {}
    }
}

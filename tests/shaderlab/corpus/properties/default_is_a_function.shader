Shader "T"
{
    Properties
    {
        _C("c", Color) = Color3(0.3,0.6,1.0) * 1.6
        _B("b", Float) = x
    }
}

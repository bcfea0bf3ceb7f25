Shader "T"
{
    SubShader
    {
        Stencil { Ref 1 Comp Equal }
        Pass { }
        Pass { Stencil { Pass Zero } }
    }
}

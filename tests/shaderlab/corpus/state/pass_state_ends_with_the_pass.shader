Shader "T"
{
    SubShader
    {
        Pass { Cull Off Stencil { Ref 1 } }
        Pass { }
    }
}

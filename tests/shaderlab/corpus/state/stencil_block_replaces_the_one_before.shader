Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Ref 1 Comp Equal }
            Stencil { Pass Zero }
        }
    }
}

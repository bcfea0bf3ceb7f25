Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Ref Comp Equal }
        }
    }
}

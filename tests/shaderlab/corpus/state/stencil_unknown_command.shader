Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Reff 1 Comp Equal }
        }
    }
}

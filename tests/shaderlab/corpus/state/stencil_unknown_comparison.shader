Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Comp Allways }
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { ReadMask 300 WriteMask 999 }
        }
    }
}

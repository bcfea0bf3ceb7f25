Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Ref 256 }
        }
    }
}

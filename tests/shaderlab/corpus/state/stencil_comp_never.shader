Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Comp Never }
        }
    }
}

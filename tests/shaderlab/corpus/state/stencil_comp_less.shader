Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Comp Less }
        }
    }
}

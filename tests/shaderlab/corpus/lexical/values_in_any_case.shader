Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull FRONT
            ZTest LEQual
            ZTest always
            Blend srcalpha ONEMINUSSRCALPHA
            BlendOp MAX
        }
    }
}

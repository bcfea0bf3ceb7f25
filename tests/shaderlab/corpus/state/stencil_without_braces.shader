Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil Ref 1
            ZWrite Of
        }
    }
}

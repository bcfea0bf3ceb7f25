Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            // } " /* not a comment of ShaderLab
            float4 f() { return float4(1, 1, 1, 1); } // "
            ENDHLSL
        }
    }
}

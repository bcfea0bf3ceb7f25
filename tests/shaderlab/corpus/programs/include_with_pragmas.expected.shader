Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            #include_with_pragmas "p.hlsl"
            ENDHLSL
        }
    }
}

Shader "T"
{
    SubShader
    {
        HLSLINCLUDE float h; ENDHLSL
        CGINCLUDE float c; ENDCG
        Pass
        {
            CGPROGRAM float p; ENDCG
        }
        Pass
        {
            HLSLPROGRAM float p; ENDHLSL
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float a; ENDHLSL
        }
        HLSLINCLUDE float b; ENDHLSL
        Pass
        {
            HLSLPROGRAM float c; ENDHLSL
        }
    }
}

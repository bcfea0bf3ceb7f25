Shader "T"
{
    SubShader
    {
        HLSLINCLUDE float a; ENDHLSL
        Pass
        {
            HLSLPROGRAM float b; ENDHLSL
        }
    }
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float c; ENDHLSL
        }
    }
}

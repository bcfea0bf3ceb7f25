Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLINCLUDE float a; ENDHLSL
            HLSLPROGRAM float b; ENDHLSL
        }
    }
}

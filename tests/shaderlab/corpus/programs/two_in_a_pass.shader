Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float a; ENDHLSL
            HLSLPROGRAM float b; ENDHLSL
        }
    }
}

Shader "T"
{
    HLSLINCLUDE
    float shared;
    ENDHLSL
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            float own;
            ENDHLSL
        }
    }
}

// Whole files are built like this.
HLSLINCLUDE
float a;
ENDHLSL
cginclude
float b;
ENDCG
Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            float c;
            ENDHLSL
        }
    }
}

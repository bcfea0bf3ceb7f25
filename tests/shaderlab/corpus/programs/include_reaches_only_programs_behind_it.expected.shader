Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float a; ENDHLSL
        }
        Pass
        {
            HLSLPROGRAM float b; 
 float c; ENDHLSL
        }
    }
}

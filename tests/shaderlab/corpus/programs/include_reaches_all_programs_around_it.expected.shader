Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float b; 
 float a; ENDHLSL
        }
        Pass
        {
            HLSLPROGRAM float b; 
 float c; ENDHLSL
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float a; 
 float b; ENDHLSL
        }
    }
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float a; 
 float c; ENDHLSL
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM float c; 
 float p; ENDCG
        }
        Pass
        {
            HLSLPROGRAM float h; 
 float p; ENDHLSL
        }
    }
}

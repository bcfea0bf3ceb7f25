Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM float a; 
 float b; ENDCG
        }
    }
    SubShader
    {
        Pass
        {
            CGPROGRAM float a; 
 float c; ENDCG
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM float a; 
 float b; 
 float c; ENDCG
        }
    }
}

Shader "T"
{
    SubShader
    {
        CGINCLUDE float a; ENDCG
        CGINCLUDE float b; ENDCG
        Pass
        {
            CGPROGRAM float c; ENDCG
        }
    }
}

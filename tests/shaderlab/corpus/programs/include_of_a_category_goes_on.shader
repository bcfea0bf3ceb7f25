Shader "T"
{
    Category
    {
        CGINCLUDE float a; ENDCG
        SubShader
        {
            Pass
            {
                CGPROGRAM float b; ENDCG
            }
        }
    }
    SubShader
    {
        Pass
        {
            CGPROGRAM float c; ENDCG
        }
    }
}

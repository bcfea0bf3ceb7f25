Shader "T"
{
    CGINCLUDE
    #pragma vertex v
    #pragma fragment f
    ENDCG
    SubShader
    {
        Pass
        {
            CGPROGRAM ENDCG
        }
    }
}

Shader "T"
{
    SubShader
    {
        CGPROGRAM
        #pragma surface a Lambert
        ENDCG
        ZWrite Off
        CGPROGRAM
        #pragma surface b Lambert
        ENDCG
    }
}

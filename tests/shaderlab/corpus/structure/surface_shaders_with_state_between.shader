Shader "T"
{
    SubShader
    {
        ZWrite On
        CGPROGRAM
        #pragma surface a Lambert
        ENDCG
        ZWrite Off
        CGPROGRAM
        #pragma surface b Lambert
        ENDCG
    }
}

Shader "S" {
    SubShader {
        CGINCLUDE
        float x;
        ENDCG
        ZWrite On
        CGPROGRAM
        #pragma surface surf Lambert
        ENDCG
        Blend SrcAlpha OneMinusSrcAlpha /* a /* b */ c */
        CGPROGRAM // ENDCG
        #pragma surface surf Lambert
        ENDCG
#warning text
    }
    Fallback Off
}

Shader "T"
{
    SubShader
    {
        Lighting Off
        Fog { Mode Off }
        Pass
        {
            CGPROGRAM float x; ENDCG
        }
    }
}

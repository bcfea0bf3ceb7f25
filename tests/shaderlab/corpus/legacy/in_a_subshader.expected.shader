Shader "T"
{
    SubShader
    {
        Pass
        {
            Lighting Off
            Fog { Mode Off }
            CGPROGRAM float x; ENDCG
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Fog { Mode Off }
            CGPROGRAM float x; ENDCG
        }
    }
}

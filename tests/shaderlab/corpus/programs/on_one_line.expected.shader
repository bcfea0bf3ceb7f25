Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
            ZWrite Off
            CGPROGRAM float x; ENDCG
        }
    }
}

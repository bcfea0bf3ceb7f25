Shader "T"
{
    SubShader
    {
        Pass
        {
            Lighting Off
            CGPROGRAM float x; ENDCG
        }
    }
}

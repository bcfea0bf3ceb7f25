Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off CGPROGRAM float x; ENDCG ZWrite Off
        }
    }
}

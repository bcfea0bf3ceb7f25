Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM
            float x;
            ENDCG
            Cull Off
            ZWrite Off
            Blend One One
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
            ZWrite Off
            Blend One One
            CGPROGRAM
            float x;
            ENDCG
        }
    }
}

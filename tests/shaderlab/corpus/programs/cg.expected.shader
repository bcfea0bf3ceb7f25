Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM
            #pragma vertex v
            #pragma fragment f
            ENDCG
        }
    }
}

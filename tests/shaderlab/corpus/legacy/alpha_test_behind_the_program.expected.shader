Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaTest Greater 0
            CGPROGRAM float x; ENDCG
        }
    }
}

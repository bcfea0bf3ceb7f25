Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM float x; ENDCG
            AlphaTest Greater 0
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Color (1, 0.5, 0, 1)
            Color [_Color]
            CGPROGRAM float x; ENDCG
        }
    }
}

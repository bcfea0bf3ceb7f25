Shader "T"
{
    SubShader
    {
        Pass
        {
            Color (0, 0, 0, [_A])
            CGPROGRAM float x; ENDCG
        }
    }
}

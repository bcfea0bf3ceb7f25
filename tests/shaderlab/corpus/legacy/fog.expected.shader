Shader "T"
{
    SubShader
    {
        Pass
        {
            Fog { Mode Linear Color (0, 0, 0, 0) Density 0.5 Range 1, [_Far] }
            CGPROGRAM float x; ENDCG
        }
    }
}

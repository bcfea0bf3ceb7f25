Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMaterial AmbientAndDiffuse
            ColorMaterial Emission
            CGPROGRAM float x; ENDCG
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Lighting On
            Lighting [_L]
            SeparateSpecular On
            CGPROGRAM float x; ENDCG
        }
    }
}

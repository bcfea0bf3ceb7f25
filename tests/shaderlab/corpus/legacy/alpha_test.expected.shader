Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaTest Greater [_Cutoff]
            AlphaTest Off
            AlphaTest On 0.5
            AlphaTest [_Op] 0.25
            CGPROGRAM float x; ENDCG
        }
    }
}

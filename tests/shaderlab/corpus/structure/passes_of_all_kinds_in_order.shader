Shader "T"
{
    SubShader
    {
        GrabPass { }
        UsePass "A/B"
        Pass { Name "P" }
        Cull Off
        CGPROGRAM
        #pragma surface s Lambert
        ENDCG
        Pass { }
    }
}

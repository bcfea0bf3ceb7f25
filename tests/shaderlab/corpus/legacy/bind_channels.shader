Shader "T"
{
    SubShader
    {
        Pass
        {
            BindChannels { Bind "Vertex", vertex Bind "texcoord", texcoord0 }
            CGPROGRAM float x; ENDCG
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaTest Greater 0.01
            BindChannels { Bind "Color", color }
            CGPROGRAM float x; ENDCG
        }
    }
}

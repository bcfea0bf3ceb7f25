Shader "T"
{
    Category
    {
        AlphaTest Greater .01
        BindChannels { Bind "Color", color }
        SubShader
        {
            Pass
            {
                CGPROGRAM float x; ENDCG
            }
        }
    }
}

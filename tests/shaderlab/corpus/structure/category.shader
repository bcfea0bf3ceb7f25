Shader "T"
{
    Category
    {
        Tags { "Queue" = "Transparent" }
        Blend SrcAlpha One
        Cull Off
        SubShader
        {
            Pass
            {
                Cull Front
            }
        }
        SubShader
        {
            Pass
            {
            }
        }
    }
}

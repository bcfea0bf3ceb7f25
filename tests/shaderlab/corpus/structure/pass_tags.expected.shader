Shader "T"
{
    SubShader
    {
        Pass
        {
            Tags { "LightMode" = "ShadowCaster" "PassFlags" = "OnlyDirectional" }
        }
    }
}

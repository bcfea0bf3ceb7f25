Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 0 DstColor SrcColor
            Blend 1 OneMinusDstColor OneMinusSrcColor
            Blend 2 DstAlpha OneMinusDstAlpha
            Blend 3 SrcAlphaSaturate Zero
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Front
            ZClip Off
            ZTest Always
            ZWrite Off
            Offset 1, 1
            Conservative On
            Blend One One
            BlendOp Max
            ColorMask RGB
            AlphaToMask On
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RGB
            Conservative On
            Offset 1, 1
            BlendOp Max
            Blend One One
            AlphaToMask On
            ZClip Off
            ZTest Always
            ZWrite Off
            Cull Front
        }
    }
}

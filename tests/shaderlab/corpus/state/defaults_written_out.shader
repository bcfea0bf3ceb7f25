Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Back
            ZTest LEqual
            ZWrite On
            ZClip True
            Offset 0, 0
            Blend Off
            BlendOp Add
            ColorMask RGBA
            AlphaToMask Off
            Conservative False
        }
    }
}

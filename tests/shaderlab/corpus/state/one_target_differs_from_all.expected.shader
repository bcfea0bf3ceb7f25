Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One One
            Blend 3 Off
            ColorMask RGB
            ColorMask 0 5
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RGB 2
        }
        Pass
        {
            Blend 1 One One
            ColorMask RGB 2
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask [_Mask] 4
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask A
        }
    }
}

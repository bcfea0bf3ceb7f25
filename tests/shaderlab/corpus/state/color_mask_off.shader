Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask Off
        }
    }
}

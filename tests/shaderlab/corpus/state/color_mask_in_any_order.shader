Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask BAR
        }
    }
}

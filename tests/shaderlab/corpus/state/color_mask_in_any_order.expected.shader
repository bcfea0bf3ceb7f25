Shader "T"
{
    SubShader
    {
        Pass
        {
            ColorMask RBA
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend SrcAlpha One, Zero One
        }
    }
}

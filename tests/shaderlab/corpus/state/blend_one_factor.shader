Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One
            ZWrite Of
        }
    }
}

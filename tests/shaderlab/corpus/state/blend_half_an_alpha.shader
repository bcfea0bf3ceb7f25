Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One One, One
            ZWrite Of
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One One, One One
        }
    }
}

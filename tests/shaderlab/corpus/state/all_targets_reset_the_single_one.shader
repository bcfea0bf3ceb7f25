Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 3 Zero One
            Blend One One
        }
    }
}

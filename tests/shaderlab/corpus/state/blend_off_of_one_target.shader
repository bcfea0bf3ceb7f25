Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One One
            Blend 1 Off
        }
    }
}

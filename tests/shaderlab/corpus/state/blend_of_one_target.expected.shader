Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 1 One One
        }
    }
}

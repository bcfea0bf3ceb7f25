Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 8 One One
        }
    }
}

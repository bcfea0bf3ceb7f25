Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 0.5 One One
        }
    }
}

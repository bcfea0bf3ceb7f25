Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One One
            Blend False
        }
    }
}

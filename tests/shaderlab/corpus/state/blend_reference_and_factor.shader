Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 0 [_S] One
            Blend 1 Zero [_D], One Zero
        }
    }
}

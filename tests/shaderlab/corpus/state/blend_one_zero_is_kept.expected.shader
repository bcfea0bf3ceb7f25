Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One Zero
        }
    }
}

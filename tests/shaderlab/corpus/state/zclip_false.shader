Shader "T"
{
    SubShader
    {
        Pass
        {
            ZClip false
        }
    }
}

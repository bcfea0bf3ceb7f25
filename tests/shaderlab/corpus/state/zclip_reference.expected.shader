Shader "T"
{
    SubShader
    {
        Pass
        {
            ZClip [_ZClip]
        }
    }
}

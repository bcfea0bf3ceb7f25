Shader "T"
{
    SubShader
    {
        Pass
        {
            ZClip Off
        }
    }
}

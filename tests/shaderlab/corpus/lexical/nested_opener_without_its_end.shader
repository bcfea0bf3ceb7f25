Shader "T"
{
    SubShader
    {
        Pass
        {
            /* a /* b */ ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            /* a /* b */ Cull Off */
            ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Cull Off
        ZWrite Off
        Pass
        {
            ZWrite On
        }
        Pass
        {
        }
    }
}

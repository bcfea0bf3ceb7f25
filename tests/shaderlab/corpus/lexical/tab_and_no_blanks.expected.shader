Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
            ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
        }
        Pass
        {
            Cull Off
            ZWrite Off
        }
    }
}

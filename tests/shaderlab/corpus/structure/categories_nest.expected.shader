Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
            ZTest Always
        }
    }
    SubShader
    {
        Pass
        {
            Cull Off
            ZWrite Off
        }
    }
}

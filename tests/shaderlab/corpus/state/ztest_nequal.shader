Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest NEqual
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
        }
    }
}

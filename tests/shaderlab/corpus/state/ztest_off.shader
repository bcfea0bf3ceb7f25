Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Off
        }
    }
}

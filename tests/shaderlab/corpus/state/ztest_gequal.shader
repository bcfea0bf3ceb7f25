Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest GEqual
        }
    }
}

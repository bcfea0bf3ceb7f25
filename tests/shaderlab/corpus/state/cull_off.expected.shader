Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
        }
    }
}

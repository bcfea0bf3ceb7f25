Shader "T"
{
    SubShader
    {
        Pass
        {
        }
    }
    SubShader
    {
        Pass
        {
            Cull Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
        }
    }
    SubShader
    {
        Pass
        {
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrit Off
            Cull Off
        }
    }
}

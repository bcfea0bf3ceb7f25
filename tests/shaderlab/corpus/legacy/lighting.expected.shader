Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Off
            Lighting Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Lighting Off
            Cull Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            #warning old shader, Cull Off }
            ZWrite Off
        }
    }
}

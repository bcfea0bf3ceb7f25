Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Less
        }
    }
}

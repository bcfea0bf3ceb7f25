Shader "T"
{
    SubShader
    {
        Pass
        {
            LOD 100
            ZWrite Off
        }
    }
}

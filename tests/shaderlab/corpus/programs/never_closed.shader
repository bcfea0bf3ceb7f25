Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
            CGPROGRAM
            float x;
        }
    }
}

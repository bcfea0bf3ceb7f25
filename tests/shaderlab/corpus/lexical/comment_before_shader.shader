// Copyright
/* more */
Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
        }
    }
}

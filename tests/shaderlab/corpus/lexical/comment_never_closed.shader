Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
            /* and the rest
        }
    }
}

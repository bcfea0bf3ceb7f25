Shader "T"
{
    SubShader
    {
        Pass
        {
            #error do not use this
            ZWrite Off
        }
    }
}

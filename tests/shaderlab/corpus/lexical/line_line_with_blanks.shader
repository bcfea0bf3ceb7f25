Shader "T"
{
    SubShader
    {
        Pass
        {
            #line 1 0 0
            ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            #line 100
            ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ENDHLSL
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            // no ENDHLSL yet
            float x;
            ENDHLSL
        }
    }
}

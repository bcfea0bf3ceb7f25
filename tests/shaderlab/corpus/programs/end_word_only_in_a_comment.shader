Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            float x; // ENDHLSL
        }
    }
}

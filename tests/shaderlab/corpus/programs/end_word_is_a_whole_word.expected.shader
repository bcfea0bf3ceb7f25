Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            float ENDHLSLX, XENDHLSL;
            ENDHLSL
        }
    }
}

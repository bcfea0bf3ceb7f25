Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            float ENDCG;
            ENDHLSL
        }
    }
}

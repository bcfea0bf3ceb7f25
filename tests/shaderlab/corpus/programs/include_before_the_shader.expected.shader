Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
float a;

            float c;
            ENDHLSL
        }
    }
}

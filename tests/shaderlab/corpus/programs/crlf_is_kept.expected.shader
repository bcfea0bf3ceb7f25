Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM float a;
             float b;
            ENDHLSL
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
    float shared;
    
            float own;
            ENDHLSL
        }
    }
}

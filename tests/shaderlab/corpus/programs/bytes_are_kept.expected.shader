Shader "T"
{
    SubShader
    {
        Pass
        {
            HLSLPROGRAM
            // größe	色   

            ENDHLSL
        }
    }
}

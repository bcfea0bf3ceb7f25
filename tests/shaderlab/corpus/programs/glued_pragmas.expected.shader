Shader "T"
{
    SubShader
    {
        Pass
        {
            CGPROGRAM
            #pragma multi_compile_instancing#define X 1
            ENDCG
        }
    }
}

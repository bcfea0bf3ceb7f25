Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
            GLSLPROGRAM
            void main() { }
            ENDGLSL
        }
    }
}

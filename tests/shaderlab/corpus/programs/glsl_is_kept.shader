Shader "T"
{
    SubShader
    {
        Pass
        {
            GLSLPROGRAM
            void main() { }
            ENDGLSL
            ZWrite Off
        }
    }
}

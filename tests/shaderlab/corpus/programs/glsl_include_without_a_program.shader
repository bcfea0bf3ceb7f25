Shader "T"
{
    SubShader
    {
        GLSLINCLUDE
        varying vec4 x;
        ENDGLSL
        Pass
        {
            ZWrite Off
        }
    }
}

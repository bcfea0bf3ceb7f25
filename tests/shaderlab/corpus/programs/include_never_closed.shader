Shader "T"
{
    SubShader
    {
    }
    HLSLINCLUDE
    float x;
}

Shader "T"
{
    SubShader
    {
        Pass
        {
        }

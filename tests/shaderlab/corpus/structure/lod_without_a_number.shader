Shader "T"
{
    SubShader
    {
        LOD High
        Pass
        {
        }
    }
}

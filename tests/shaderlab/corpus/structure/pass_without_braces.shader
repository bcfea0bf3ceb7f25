Shader "T"
{
    SubShader
    {
        Pass
        LOD 100
    }
}

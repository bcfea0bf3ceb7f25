Shader "T"
{
    SubShader
    {
        LOD 100
    }
}

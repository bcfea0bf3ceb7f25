Shader "T"
{
    SubShader
    {
        LOD 150
    }
    SubShader
    {
        LOD 100
    }
}

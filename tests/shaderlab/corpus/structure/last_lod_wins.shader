Shader "T"
{
    SubShader
    {
        LOD 200
        LOD 100
    }
}

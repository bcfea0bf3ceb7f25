Shader "T"
{
    SubShader
    {
        LOD 200
    }
}

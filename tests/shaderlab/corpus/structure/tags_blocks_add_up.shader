Shader "T"
{
    SubShader
    {
        Tags { "A" = "1" }
        LOD 100
        Tags { "B" = "2" }
    }
}

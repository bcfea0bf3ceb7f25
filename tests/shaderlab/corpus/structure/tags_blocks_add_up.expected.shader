Shader "T"
{
    SubShader
    {
        Tags { "A" = "1" "B" = "2" }
        LOD 100
    }
}

Shader "T"
{
    SubShader
    {
        Tags { "A" = "1" "B" = "2" }
        Tags { "A" = "3" }
    }
}

Shader "T"
{
    SubShader
    {
        Tags { "A" = "3" "B" = "2" }
    }
}

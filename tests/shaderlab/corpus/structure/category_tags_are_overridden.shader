Shader "T"
{
    Category
    {
        Tags { "Queue" = "Transparent" "A" = "1" }
        SubShader
        {
            Tags { "Queue" = "Overlay" }
        }
    }
}

Shader "T"
{
    Category
    {
        SubShader { Pass { } }
        Cull Off
        SubShader { Pass { } }
    }
}

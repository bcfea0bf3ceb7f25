Shader "T"
{
    Category
    {
        Cull Off
        SubShader { Pass { } }
    }
    SubShader { Pass { } }
}

Shader "T"
{
    SubShader
    {
        Tags {}
        Pass { Tags { } }
    }
}

Shader "T"
{
    SubShader
    {
        Name "X"
        Pass { }
    }
}

Shader "T"
{
    Properties { }
    SubShader { Pass { } }
}

Shader "T"
{
    SubShader
    {
        GrabPass { }
    }
}

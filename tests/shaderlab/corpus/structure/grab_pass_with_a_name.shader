Shader "T"
{
    SubShader
    {
        GrabPass { Name "BASE" }
    }
}

Shader "T"
{
    SubShader
    {
        GrabPass { "_Behind" }
        Pass
        {
        }
    }
}

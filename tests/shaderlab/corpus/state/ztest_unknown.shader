Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest LesEqual
        }
    }
}

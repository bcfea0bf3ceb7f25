Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Never
            ZTest On
        }
    }
}

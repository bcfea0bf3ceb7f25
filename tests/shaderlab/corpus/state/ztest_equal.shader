Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Equal
        }
    }
}

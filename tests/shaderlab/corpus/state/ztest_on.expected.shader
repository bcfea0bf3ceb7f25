Shader "T"
{
    SubShader
    {
        Pass
        {
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            hlslprogram
             float x;
            EndHlsl
        }
    }
}

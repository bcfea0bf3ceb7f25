Shader "T"
{
    SubShader
    {
        Pass
        {
            Conservative On
        }
    }
}

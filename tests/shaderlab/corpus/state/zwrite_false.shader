Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite False
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Yes
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Name "X
            ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Never
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Always
        }
    }
}

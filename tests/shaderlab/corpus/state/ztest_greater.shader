Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Greater
        }
    }
}

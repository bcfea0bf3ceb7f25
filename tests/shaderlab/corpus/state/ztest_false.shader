Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest False
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest Disabled
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest NotEqual
        }
    }
}

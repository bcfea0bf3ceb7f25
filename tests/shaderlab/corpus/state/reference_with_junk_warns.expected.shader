Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest [_Op]
        }
    }
}

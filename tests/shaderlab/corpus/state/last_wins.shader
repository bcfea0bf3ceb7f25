Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull [_Cull]
            ZTest [_ZTest]
            Cull Front
            ZTest LEqual
        }
    }
}

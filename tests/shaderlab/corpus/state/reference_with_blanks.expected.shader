Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull [_Cull]
        }
    }
}

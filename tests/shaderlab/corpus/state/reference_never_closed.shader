Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull [_Cull
            ZWrite Of
        }
    }
}

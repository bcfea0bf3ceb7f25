Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull [Cull]
            ZWrite [Pass]
        }
    }
}

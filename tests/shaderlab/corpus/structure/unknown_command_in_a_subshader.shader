Shader "T"
{
    SubShader
    {
        Paas
        {
            Cull Of
        }
        LOD 100
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull 2
            ZWrite Of
        }
    }
}

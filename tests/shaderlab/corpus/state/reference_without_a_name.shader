Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull [ ]
            ZWrite Of
        }
    }
}

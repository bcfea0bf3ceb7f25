Shader "T"
{
    SubShader
    {
        Pass
        {
            Lighting
            ZWrite Of
        }
    }
}

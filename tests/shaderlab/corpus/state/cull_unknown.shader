Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Bakc
            ZWrite Of
        }
    }
}

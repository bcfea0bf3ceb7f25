Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Front
        }
    }
}

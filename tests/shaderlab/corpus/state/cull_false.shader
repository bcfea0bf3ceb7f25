Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull False
        }
    }
}

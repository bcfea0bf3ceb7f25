Shader "T"
{
    SubShader
    {
        Pass
        {
            Conservative True
        }
    }
}

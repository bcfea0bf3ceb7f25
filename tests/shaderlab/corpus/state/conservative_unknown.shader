Shader "T"
{
    SubShader
    {
        Pass
        {
            Conservative Maybe
        }
    }
}

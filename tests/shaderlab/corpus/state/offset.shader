Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset -1, 2
        }
    }
}

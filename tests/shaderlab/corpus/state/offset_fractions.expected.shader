Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset -0.5, -0.5
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Name "A"
        }
        Pass
        {
            Name "B"
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset Off, 1
            ZWrite Of
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Name "My Pass (1)"
        }
    }
}

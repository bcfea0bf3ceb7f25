Shader "T"
{
    SubShader
    {
        Pass
        {
            AlphaTest Gretaer 0.5
        }
    }
}

Shader "T"
{
    SubShader
    {
        UsePass
        Pass
        {
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp 2 Max
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Plus
        }
    }
}

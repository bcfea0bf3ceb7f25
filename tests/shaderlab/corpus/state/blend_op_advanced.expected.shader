Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Multiply
        }
    }
}

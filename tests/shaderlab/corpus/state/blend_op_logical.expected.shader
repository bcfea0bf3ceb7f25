Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp LogicalXor
        }
    }
}

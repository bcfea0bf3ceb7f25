Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp [_Op], [_OpA]
        }
    }
}

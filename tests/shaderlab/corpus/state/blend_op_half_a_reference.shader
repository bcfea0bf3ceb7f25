Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Add, [_OpA]
        }
    }
}

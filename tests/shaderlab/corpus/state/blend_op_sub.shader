Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Sub, RevSub
        }
    }
}

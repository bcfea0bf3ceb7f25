Shader "T"
{
    SubShader
    {
        Pass
        {
            ZTest [_Z]
            Blend [_S] [_D], [_SA] [_DA]
            BlendOp [_O], [_OA]
        }
    }
}

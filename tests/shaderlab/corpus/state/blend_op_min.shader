Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Min
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Max
        }
    }
}

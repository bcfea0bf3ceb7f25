Shader "T"
{
    SubShader
    {
        Pass
        {
            BlendOp Max, Add
        }
    }
}

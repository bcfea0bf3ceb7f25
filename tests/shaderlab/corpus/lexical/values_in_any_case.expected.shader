Shader "T"
{
    SubShader
    {
        Pass
        {
            Cull Front
            ZTest Always
            Blend SrcAlpha OneMinusSrcAlpha
            BlendOp Max
        }
    }
}

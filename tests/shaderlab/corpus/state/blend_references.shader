Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend [_Src] [_Dst], [_SrcA] [_DstA]
        }
    }
}

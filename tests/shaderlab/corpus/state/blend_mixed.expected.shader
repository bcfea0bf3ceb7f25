Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend One [_Dst], [_SrcA] Zero
        }
    }
}

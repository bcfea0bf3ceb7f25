Shader "T"
{
    SubShader
    {
        Pass
        {
            Material { Difuse [_C] }
        }
    }
}

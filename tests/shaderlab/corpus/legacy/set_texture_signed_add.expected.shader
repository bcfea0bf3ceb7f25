Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_A] { Combine Texture * Primary +- Constant }
            SetTexture [_B] { Combine Texture Dot3 Primary }
        }
    }
}

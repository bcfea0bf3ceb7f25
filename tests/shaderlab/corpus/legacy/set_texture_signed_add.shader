Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_A] { Combine texture * primary +- constant }
            SetTexture [_B] { Combine texture Dot3 primary }
        }
    }
}

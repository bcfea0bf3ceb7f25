Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_A] { Combine Texture * Primary + Constant Double, One - Texture Alpha Quad }
            SetTexture [_B] { Combine Previous - Texture }
            SetTexture [_C] { Combine Texture + Previous }
        }
    }
}

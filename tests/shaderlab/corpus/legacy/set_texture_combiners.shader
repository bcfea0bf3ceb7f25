Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_A] { Combine texture * primary + constant Double, one - texture alpha Quad }
            SetTexture [_B] { Combine previous - texture }
            SetTexture [_C] { Combine texture + previous }
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_MainTex] { Matrix [_M] ConstantColor (0, 0, 0, [_Accum]) Combine Constant Lerp (Texture) Previous, Texture * Constant }
        }
    }
}

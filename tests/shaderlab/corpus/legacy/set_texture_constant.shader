Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_MainTex]
            {
                Matrix [_M]
                ConstantColor (0,0,0,[_Accum])
                Combine constant lerp(texture) previous, texture * constant
            }
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_MainTex] { Combine texture * primary }
        }
    }
}

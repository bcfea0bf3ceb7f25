Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture [_MainTex] { Combine Texture * Primary }
        }
    }
}

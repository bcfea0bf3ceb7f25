Shader "T"
{
    SubShader
    {
        Pass
        {
            SetTexture _MainTex { }
        }
    }
}

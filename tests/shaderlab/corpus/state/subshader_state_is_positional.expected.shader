Shader "T"
{
    SubShader
    {
        Pass
        {
        }
        Pass
        {
            ZWrite Off
            Blend SrcAlpha OneMinusSrcAlpha
        }
        Pass
        {
            ZWrite Off
        }
    }
}

Shader "T"
{
    SubShader
    {
        ZWrite On
        Pass { }
        ZWrite Off
        Blend SrcAlpha OneMinusSrcAlpha
        Pass { }
        Blend Off
        Pass { }
    }
}

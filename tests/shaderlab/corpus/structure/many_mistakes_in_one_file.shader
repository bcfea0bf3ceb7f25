Shader "T"
{
    SubShader
    {
        Pass
        {
            Cul Off
            ZTest Foo
            ZWrite Off
            Blend One
        }
    }
}

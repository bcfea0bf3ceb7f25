Shader "T"
{
    SubShader
    {
        Pass
        {
            Fog { Mode Foo }
        }
    }
}

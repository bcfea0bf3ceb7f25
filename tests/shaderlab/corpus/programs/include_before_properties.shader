Shader "T"
{
    CGINCLUDE
    float shared;
    ENDCG
    Properties
    {
        _A("a", Float) = 1
    }
    SubShader
    {
        Pass
        {
            CGPROGRAM
            ENDCG
        }
    }
}

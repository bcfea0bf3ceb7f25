Shader "T"
{
    Properties
    {
        _A("a", Float) = 1
    }
    SubShader
    {
        Pass
        {
            CGPROGRAM
    float shared;
    
            ENDCG
        }
    }
}

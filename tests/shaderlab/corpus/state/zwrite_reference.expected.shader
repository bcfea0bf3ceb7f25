Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite [_ZWrite]
        }
    }
}

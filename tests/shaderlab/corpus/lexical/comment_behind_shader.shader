Shader "T"
{
    SubShader
    {
        Pass
        {
            ZWrite Off
        }
    }
}
/*ASEBEGIN
Version=18900
Node;"{}"
ASEEND*/
//CHKSM=ABC
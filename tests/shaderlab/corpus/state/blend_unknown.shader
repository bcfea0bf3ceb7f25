Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend SrcAlpah One
            ZWrite Of
        }
    }
}

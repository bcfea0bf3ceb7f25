Shader "T"
{
    SubShader
    {
        Pass
        {
            Material { Diffuse [_Color]
        }
    }
}

Shader "T"
{
    SubShader
    {
        Pass
        {
            Material { Diffuse [_Color] Ambient (1, 1, 1, 1) Specular [_Spec] Emission [_Em] Shininess [_Shine] }
        }
    }
}

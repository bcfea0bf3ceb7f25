Shader "L" {
    SubShader {
        Lighting Off Fog { Mode Exp2 Color (0,0,0,[_A]) Density .5 Range 0, 1 }
        Pass {
            Material { Diffuse [_C] Shininess [_S] } ColorMaterial Emission SeparateSpecular On
            AlphaTest Greater [_Cutoff] Color (1,1,1,1)
            BindChannels { Bind "Vertex", vertex Bind "texcoord", texcoord0 }
            SetTexture [_M] { ConstantColor (1,1,1,[_A]) Matrix [_X] combine one - texture * primary double, constant }
            SetTexture [_N] { combine previous lerp (texture alpha) constant quad }
        }
    }
}

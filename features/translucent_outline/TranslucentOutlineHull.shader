// TranslucentOutline with a width that holds: each vertex moves by so many pixels on the screen,
// across the silhouette that its outline normal (BakeOutlineNormals, TEXCOORD7) makes there. Meshes
// without that channel go by their normals. The same passes; the band is drawn once a pixel, which
// leaves its stencil at 0.
Shader "Limn/TranslucentOutlineHull"
{
    Properties
    {
        [HDR] _OutlineColor ("Colour, linear", Color) = (0, 1, 1, 1)
        _OutlineWidth ("Width in pixels", Range(0, 10)) = 5
        [Enum(UnityEngine.Rendering.BlendMode)] _OutlineSrcBlend ("Source factor", Int) = 5
        [Enum(UnityEngine.Rendering.BlendMode)] _OutlineDstBlend ("Destination factor", Int) = 10
        [Enum(UnityEngine.Rendering.BlendOp)] _OutlineBlendOp ("Operation", Int) = 0
    }
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" }

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "limn/outline/Hull.hlsl"

        CBUFFER_START(UnityPerMaterial)
        float4 _OutlineColor;
        float _OutlineWidth;
        CBUFFER_END

        struct Attributes
        {
            float4 positionOS : POSITION;
            float3 normalOS : NORMAL;
            float3 outlineOS : TEXCOORD7;
        };

        float4 HullVertex(Attributes input) : SV_POSITION
        {
            return HullPosition(input.positionOS.xyz, input.normalOS, input.outlineOS, _OutlineWidth);
        }

        float4 HullFragment() : SV_Target { return _OutlineColor; }
        ENDHLSL

        Pass
        {
            Name "StencilMask"
            Tags { "LightMode" = "StencilMask" }
            Cull Front
            ZWrite Off
            ColorMask 0
            Stencil { Ref 255 Comp Always Pass Replace ZFail Replace }

            HLSLPROGRAM
            #pragma vertex HullVertex
            #pragma fragment HullFragment
            ENDHLSL
        }

        Pass
        {
            Name "Outline"
            Tags { "LightMode" = "SRPDefaultUnlit" }
            Cull Front
            ZWrite Off
            Blend [_OutlineSrcBlend] [_OutlineDstBlend]
            BlendOp [_OutlineBlendOp]
            // Once a pixel, so that a translucent band is even where layers of the hull overlap.
            Stencil { Ref 255 Comp Equal Pass Zero }

            HLSLPROGRAM
            #pragma vertex HullVertex
            #pragma fragment HullFragment
            ENDHLSL
        }
    }
}

// A translucent solid of one colour, drawn once a pixel however many of its layers lie there. Its
// mask takes pixels that TranslucentOutline marked from 255 to 254; drawing takes them on to 253,
// so that no layer finds 254 a second time. Zero, which a cleared stencil holds, is never matched.
Shader "Limn/TranslucentSolid"
{
    Properties
    {
        [HDR] _Color ("Colour, linear; alpha is opacity", Color) = (0.2, 0.8, 0.8, 0.3)
        [Enum(UnityEngine.Rendering.CullMode)] _Cull ("Faces the mask leaves out", Int) = 2
        [Enum(UnityEngine.Rendering.BlendMode)] _SrcBlend ("Source factor", Int) = 5
        [Enum(UnityEngine.Rendering.BlendMode)] _DstBlend ("Destination factor", Int) = 10
        [Enum(UnityEngine.Rendering.BlendOp)] _BlendOp ("Operation", Int) = 0
    }
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "RenderType" = "Transparent" "Queue" = "Transparent" }

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        CBUFFER_START(UnityPerMaterial)
        float4 _Color;
        CBUFFER_END

        float4 SolidVertex(float4 positionOS : POSITION) : SV_POSITION
        {
            return TransformObjectToHClip(positionOS.xyz);
        }

        float4 SolidFragment() : SV_Target { return _Color; }
        ENDHLSL

        Pass
        {
            Name "StencilMask"
            Tags { "LightMode" = "StencilMask" }
            Cull [_Cull]
            ZWrite Off
            ColorMask 0
            Stencil { Ref 255 Comp Equal Pass DecrSat }

            HLSLPROGRAM
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            ENDHLSL
        }

        Pass
        {
            Name "Solid"
            Tags { "LightMode" = "SRPDefaultUnlit" }
            Cull Back
            ZWrite Off
            Blend [_SrcBlend] [_DstBlend]
            BlendOp [_BlendOp]
            Stencil { Ref 254 Comp Equal Pass DecrSat }

            HLSLPROGRAM
            #pragma vertex SolidVertex
            #pragma fragment SolidFragment
            ENDHLSL
        }
    }
}

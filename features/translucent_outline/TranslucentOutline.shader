// The band around a translucent solid: a hull, moved outwards along the normals. It comes first of
// the two materials of an object. Its mask marks the hull with 255, the solid's mask then takes its
// own pixels down to 254; what is left of 255 is the band.
//
// The width is turned into metres at the depth of each vertex, which is right where the normal is
// perpendicular to the view axis and the camera is a perspective one; README.md has the table.
Shader "Limn/TranslucentOutline"
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

        CBUFFER_START(UnityPerMaterial)
        float4 _OutlineColor;
        float _OutlineWidth;
        CBUFFER_END

        struct Attributes
        {
            float4 positionOS : POSITION;
            float3 normalOS : NORMAL;
        };

        float4 HullVertex(Attributes input) : SV_POSITION
        {
            float depth = abs(mul(UNITY_MATRIX_MV, input.positionOS).z);
            // Negative where y is turned over, as for all that is drawn into a texture.
            float metresPerPixel = 2.0 * depth / abs(UNITY_MATRIX_P._m11) / _ScreenParams.y;
            float3 normalWS = TransformObjectToWorldNormal(input.normalOS);
            float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
            return TransformWorldToHClip(positionWS + normalWS * (_OutlineWidth * metresPerPixel));
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
            // Back faces lie behind what the object stands on: the depth test must not stop them.
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
            Stencil { Ref 255 Comp Equal }

            HLSLPROGRAM
            #pragma vertex HullVertex
            #pragma fragment HullFragment
            ENDHLSL
        }
    }
}

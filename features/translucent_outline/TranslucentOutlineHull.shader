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

        // Object to world for normals, by the cofactors: unlike the inverse they exist for every
        // scale. A scale of zero in one axis leaves one direction of them only; there the outline
        // is that of a flat figure, whose normals go like directions within it.
        float3 NormalToWorld(float3 n)
        {
            float3x3 columns = transpose((float3x3)UNITY_MATRIX_M);
            float3 x = columns[0];
            float3 y = columns[1];
            float3 z = columns[2];
            float3 largest = max(abs(x), max(abs(y), abs(z)));
            float unit = 1.0 / max(max(largest.x, max(largest.y, largest.z)), 1e-30);
            x *= unit;
            y *= unit;
            z *= unit;
            float volume = dot(x, cross(y, z));
            float3 flat = x * n.x + y * n.y + z * n.z;
            float3 upright = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
            return abs(volume) < 1e-9 ? flat : upright * unity_WorldTransformParams.w;
        }

        // How a point that moves by v moves on the screen, in pixels times an unknown factor.
        float2 Movement(float3 v, float4 positionCS)
        {
            float4 moved = mul(UNITY_MATRIX_P, float4(v, 0.0));
            return (moved.xy * positionCS.w - positionCS.xy * moved.w) * _ScreenParams.xy;
        }

        // Across the silhouette, in pixels times an unknown factor. The plane that touches the
        // object there goes through the camera, so it is a line on the screen: this is its normal,
        // which is not where the surface's normal seems to point unless it is seen head on.
        float2 AcrossSilhouette(float3 normalVS)
        {
            return normalVS.xy / (float2(UNITY_MATRIX_P._m00, UNITY_MATRIX_P._m11) * _ScreenParams.xy);
        }

        float4 HullVertex(Attributes input) : SV_POSITION
        {
            float3 outlineOS = dot(input.outlineOS, input.outlineOS) > 0.0 ? input.outlineOS : input.normalOS;
            float miter = length(outlineOS);
            float3 positionVS = mul(UNITY_MATRIX_MV, float4(input.positionOS.xyz, 1.0)).xyz;
            float3 normalVS = SafeNormalize(mul((float3x3)UNITY_MATRIX_V, NormalToWorld(outlineOS)));
            float4 positionCS = mul(UNITY_MATRIX_P, float4(positionVS, 1.0));
            bool orthographic = unity_OrthoParams.w > 0.5;

            // There is no place on the screen for what is behind the camera: there the hull is
            // moved in space, by the size that a pixel has at the near plane.
            if (!orthographic && positionCS.w < _ProjectionParams.y)
            {
                float metresPerPixel = 2.0 * _ProjectionParams.y / (UNITY_MATRIX_P._m11 * _ScreenParams.y);
                positionVS += normalVS * (miter * _OutlineWidth * metresPerPixel);
                return mul(UNITY_MATRIX_P, float4(positionVS, 1.0));
            }

            // The part of the normal across the line of sight; its length brings the miter to the
            // screen. At least 1, so that a vertex beside the silhouette is not left behind.
            float3 sight = orthographic ? float3(0.0, 0.0, -1.0) : SafeNormalize(positionVS);
            float along = dot(normalVS, sight);
            float reach = max(1.0, miter * sqrt(saturate(1.0 - along * along)));
            float2 direction = AcrossSilhouette(normalVS);
            if (dot(normalVS.xy, normalVS.xy) < 1e-6)
            {
                // It points along the view axis: away from the object's middle then.
                float3 middleVS = mul(UNITY_MATRIX_MV, float4(0.0, 0.0, 0.0, 1.0)).xyz;
                direction = Movement(positionVS - middleVS, positionCS);
                reach = 1.0;
            }
            direction *= rsqrt(max(dot(direction, direction), 1e-30));
            positionCS.xy += direction * (reach * _OutlineWidth * 2.0 * positionCS.w) / _ScreenParams.xy;
            return positionCS;
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

// Outlines of any width by the distance to the nearest place on the silhouette's edge. The textures
// are as large as the region that the outline can touch, see WideOutlineRenderPass.
Shader "Hidden/Limn/WideOutline"
{
    Properties
    {
        _BaseMap ("Of a cutout", 2D) = "white" {}
        _BaseColor ("Of a cutout", Color) = (1, 1, 1, 1)
        _Cutoff ("Of a cutout", Float) = 0.5
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }

        ZTest Always
        ZWrite Off
        Cull Off

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
        #include "limn/outline/NearestSeed.hlsl"
        #if defined(_VISIBLE_ONLY)
        #include "limn/outline/SeenByCamera.hlsl"
        #endif

        float4 _WideOutlineCorner; // xy: of the textures in the picture, zw: 1 / the picture; pixels

        float4 MaskVertex(float4 positionOS : POSITION) : SV_POSITION
        {
            return TransformObjectToHClip(positionOS.xyz);
        }

        float4 WholeTarget(uint vertexID : SV_VertexID) : SV_POSITION
        {
            return GetFullScreenTriangleVertexPosition(vertexID);
        }
        ENDHLSL

        Pass // 0: the objects
        {
            Name "Mask"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment MaskFragment
            #pragma multi_compile_local _ _VISIBLE_ONLY
            #if defined(_VISIBLE_ONLY)
            half MaskFragment(float4 position : SV_POSITION) : SV_Target
            {
                clip(SeenByCamera(position, _WideOutlineCorner) ? 1.0 : -1.0);
                return 1;
            }
            #else
            half MaskFragment() : SV_Target
            {
                return 1;
            }
            #endif
            ENDHLSL
        }

        Pass // 1: those that their texture cuts out, smooth along the cut
        {
            Name "Cutout Mask"
            Tags { "LimnWithinMesh" = "True" }
            BlendOp Max

            HLSLPROGRAM
            #pragma vertex CutoutVertex
            #pragma fragment CutoutFragment
            #pragma multi_compile_local _ _VISIBLE_ONLY
            #include "limn/outline/Cutout.hlsl"
            half CutoutFragment(CutoutVaryings input) : SV_Target
            {
                #if defined(_VISIBLE_ONLY)
                clip(SeenByCamera(input.position, _WideOutlineCorner) ? 1.0 : -1.0);
                #endif
                return CutoutPart(input.uv);
            }
            ENDHLSL
        }

        Pass // 2: the places on the edge (xy), and the part of each texel that is inside (z)
        {
            Name "Seeds"
            Tags { "LimnFullScreen" = "0 0 0 0 where _BlitTexture is 0 within 1 texels" }

            HLSLPROGRAM
            #pragma vertex WholeTarget
            #pragma fragment SeedFragment
            float _WideOutlineClosesSlits;

            // The mean of four samples comes in 8 bits, and devices round half of 255 either way:
            // what is that near to a whole number of samples is that number.
            float PartInside(float mean)
            {
                float samples = round(mean * 4.0) * 0.25;
                return abs(mean - samples) < 0.6 / 255.0 ? samples : mean;
            }

            float4 SeedFragment(float4 position : SV_POSITION) : SV_Target
            {
                float mask[9];
                for (int i = 0; i < 9; i++)
                {
                    mask[i] = PartInside(SeedTexel(position.xy + float2(i % 3 - 1, i / 3 - 1)).r);
                }
                EdgePlace place = FindEdge(mask, _WideOutlineClosesSlits > 0.0);
                return float4(place.isEdge ? EncodeSeed(place.seed, _WideOutlineRange) : 0.0,
                              place.inside, EncodeDirection(place.outwards));
            }
            ENDHLSL
        }

        Pass // 3: one step of a jump flood
        {
            Name "Flood"
            Tags { "LimnFullScreen" = "0 0 0 0 where _BlitTexture is 0 within _WideOutlineStep texels" }

            HLSLPROGRAM
            #pragma vertex WholeTarget
            #pragma fragment FloodFragment
            float2 FloodFragment(float4 position : SV_POSITION) : SV_Target
            {
                return FloodSeeds(position.xy);
            }
            ENDHLSL
        }

        Pass // 4: the nearest places of each column
        {
            Name "Columns"
            Tags { "LimnFullScreen" = "0 0 0 0 where _BlitTexture is 0 within _WideOutlineStep texels" }

            HLSLPROGRAM
            #pragma vertex WholeTarget
            #pragma fragment ColumnFragment
            float4 ColumnFragment(float4 position : SV_POSITION) : SV_Target
            {
                float row = (position.y + _WideOutlineCorner.y) * _WideOutlineCorner.w;
                bool isComposited = row > 0.0 && row < 1.0;
                return isComposited ? ColumnSeeds(position.xy) : 0.0;
            }
            ENDHLSL
        }

        HLSLINCLUDE
        #include "limn/outline/DistanceBand.hlsl"

        TEXTURE2D_X(_WideOutlineSeeds); // what the pass Seeds left

        float4 SeedsAt(float2 center)
        {
            return SAMPLE_TEXTURE2D_X_LOD(_WideOutlineSeeds, sampler_PointClamp,
                center * _WideOutlineSize.xy, 0);
        }

        // inside: of the pixel
        float4 OutlineColor(float2 center, float2 toEdge, float inside)
        {
            float2 outwards = DecodeDirection(SeedsAt(center + toEdge).w);
            return ColorInBand(AlongEdge(toEdge, outwards), inside);
        }
        ENDHLSL

        Pass // 5: the outline, where a flood has found the nearest places
        {
            Name "Composite Flood"
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma vertex WholeTarget
            #pragma fragment CompositeFragment
            float4 CompositeFragment(float4 position : SV_POSITION) : SV_Target
            {
                float2 center = position.xy - _WideOutlineCorner.xy;
                float inside = SeedsAt(center).z;
                if (IsBesideBand(inside))
                {
                    return 0.0;
                }
                return OutlineColor(center, DecodeSeed(SeedTexel(center).xy, _WideOutlineRange), inside);
            }
            ENDHLSL
        }

        Pass // 6: the outline, where columns are all there is
        {
            Name "Composite Columns"
            Blend SrcAlpha OneMinusSrcAlpha, One OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma vertex WholeTarget
            #pragma fragment CompositeFragment
            float4 CompositeFragment(float4 position : SV_POSITION) : SV_Target
            {
                float2 center = position.xy - _WideOutlineCorner.xy;
                float inside = SeedsAt(center).z;
                if (IsBesideBand(inside))
                {
                    return 0.0;
                }
                return OutlineColor(center, RowSeed(center), inside);
            }
            ENDHLSL
        }
    }
}

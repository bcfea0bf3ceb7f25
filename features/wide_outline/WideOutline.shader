// Outlines of any width by the distance to the nearest place on the silhouette's edge. The textures
// are as large as the region that the outline can touch; WideOutlineRenderPass says which passes a
// width takes.
Shader "Hidden/Limn/WideOutline"
{
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

        float4 _WideOutlineCorner; // xy: of the textures in the picture, zw: 1 / the picture; pixels

        float4 MaskVertex(float4 positionOS : POSITION) : SV_POSITION
        {
            return TransformObjectToHClip(positionOS.xyz);
        }

        // SV_POSITION says which texel it is.
        float4 WholeTarget(uint vertexID : SV_VertexID) : SV_POSITION
        {
            return GetFullScreenTriangleVertexPosition(vertexID);
        }
        ENDHLSL

        Pass // 0: the objects, whatever stands in front of them
        {
            Name "Mask"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment MaskFragment
            half MaskFragment() : SV_Target
            {
                return 1;
            }
            ENDHLSL
        }

        Pass // 1: what the camera saw of them
        {
            Name "Visible Mask"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment VisibleFragment
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
            half VisibleFragment(float4 position : SV_POSITION) : SV_Target
            {
                // The scene's depth may be that of another place in the pixel: allow for the slope.
                // Nothing is known to stand in front of what is outside of the picture.
                float2 uv = (position.xy + _WideOutlineCorner.xy) * _WideOutlineCorner.zw;
                float slope = abs(ddx(position.z)) + abs(ddy(position.z));
                float front = SampleSceneDepth(saturate(uv));
                bool isOutside = any(uv < 0.0) || any(uv > 1.0);
                clip(isOutside || position.z * (1.0 + 1e-6) + slope >= front ? 1.0 : -1.0);
                return 1;
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
            float4 SeedFragment(float4 position : SV_POSITION) : SV_Target
            {
                float mask[9];
                for (int i = 0; i < 9; i++)
                {
                    mask[i] = SeedTexel(position.xy + float2(i % 3 - 1, i / 3 - 1)).r;
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
                return ColumnSeeds(position.xy);
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

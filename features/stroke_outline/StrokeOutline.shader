// The exact outline: silhouette edges as strokes on the screen. StrokeOutlinePass runs the passes in
// order. Lengths are pixels of the picture, y down, in a texture that is a part of it.
Shader "Hidden/Limn/StrokeOutline"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "limn/outline/BoxCoverage.hlsl"
        #include "limn/outline/ScreenQuads.hlsl"

        float4 _OutlineRegion;  // corner, size
        float4 _OutlinePicture; // size

        TEXTURE2D(_StrokeDepth);
        float4 _StrokeDepth_TexelSize;

        // The group's own depth at a place of the region, 1 near ... 0 far, 0 where it is not.
        float OwnDepth(float2 pixel)
        {
            return limn_Nearness(SAMPLE_TEXTURE2D_LOD(_StrokeDepth, sampler_PointClamp,
                                                      pixel * _StrokeDepth_TexelSize.xy, 0).r);
        }
        ENDHLSL

        Pass // 0: the objects of the group, alone
        {
            Name "Own Depth"
            Tags { "LimnWithinMesh" = "True" }
            ZWrite On
            ZTest LEqual
            Cull Off
            ColorMask 0

            HLSLPROGRAM
            #pragma vertex DepthVertex
            #pragma fragment DepthFragment

            float4 DepthVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }
            half4 DepthFragment() : SV_Target { return 0; }
            ENDHLSL
        }

        Pass // 1: strokes on the outer side of silhouette edges
        {
            Name "Strokes"
            ZWrite Off
            ZTest Always
            Cull Off
            Blend One One
            BlendOp Max
            BlendOp 1 Add, Max

            HLSLPROGRAM
            #pragma vertex StrokeVertex
            #pragma fragment StrokeFragment
            #pragma shader_feature_local _ _STROKE_OCCLUSION

            #if defined(_STROKE_OCCLUSION)
            TEXTURE2D(_CameraDepthTexture);
            #endif

            float4 _Strokes[1022];
            float _OutlineWidth;

            struct StrokeVaryings
            {
                float4 positionCS : SV_POSITION;
                nointerpolation float4 ends : TEXCOORD0;
                nointerpolation float2 depths : TEXCOORD1;
            };

            StrokeVaryings StrokeVertex(uint vertexID : SV_VertexID)
            {
                float4 ends = _Strokes[vertexID / 6u * 2u];
                float4 more = _Strokes[vertexID / 6u * 2u + 1u];
                float2 along = ends.zw - ends.xy;
                float squared = dot(along, along);
                along = squared > 0.0 ? along * rsqrt(squared) : float2(1.0, 0.0);
                float2 outward = float2(along.y, -along.x);

                float2 corner = QuadCorner(vertexID);
                float2 pixel = corner.x > 0.0 ? ends.zw + along * more.y : ends.xy - along * more.x;
                pixel += outward * (corner.y > 0.0 ? _OutlineWidth + 1.0 : -1.0);
                StrokeVaryings output;
                output.positionCS = more.x < 0.0 ? float4(2.0, 2.0, 0.5, 1.0)
                                                 : PixelToClip(pixel, _OutlineRegion.zw);
                output.ends = ends;
                output.depths = more.zw;
                return output;
            }

            // By how much the edge corrects what the pixel's centre says of the objects' coverage.
            // across: of the centre from the edge, outwards; share: of the pixel along the edge
            float EdgeCorrection(float2 pixel, float2 nearest, float2 outward, float across,
                                 float share)
            {
                if (share <= 0.0 || abs(across) >= 0.71 || OwnDepth(nearest + outward) > 0.0)
                {
                    return 0.0; // too far away, or the objects go on behind the edge
                }
                float beyond = BoxCoverage(outward, across);
                // On the edge the rasteriser decides which side a centre is on.
                bool isInside = abs(across) < 0.01 ? OwnDepth(pixel) > 0.0 : across < 0.0;
                return (isInside ? -beyond : 1.0 - beyond) * share;
            }

            #if defined(_STROKE_OCCLUSION)
            // The nearest that the objects' surface can be anywhere in a pixel, as far as what they
            // have in it and around it says; 0 where they have nothing.
            float NearestInPixel(float2 pixel)
            {
                float most = 0.0;
                float2 change = 0.0; // from one pixel to the next
                for (int y = -1; y <= 1; ++y)
                {
                    for (int x = -1; x <= 1; ++x)
                    {
                        float own = OwnDepth(pixel + float2(x, y));
                        float right = OwnDepth(pixel + float2(x + 1, y));
                        float below = OwnDepth(pixel + float2(x, y + 1));
                        most = max(most, own);
                        change.x = max(change.x, own > 0.0 && right > 0.0 ? abs(right - own) : 0.0);
                        change.y = max(change.y, own > 0.0 && below > 0.0 ? abs(below - own) : 0.0);
                    }
                }
                return most > 0.0 ? most + 0.5 * (change.x + change.y) : 0.0;
            }

            // Whether the silhouette is seen: just inside of it, where the objects have a surface.
            bool IsVisible(float2 nearest, float2 outward, float depth)
            {
                float2 inside = floor(nearest - outward * 0.5) + 0.5; // of a pixel, its centre
                float2 uv = (inside + _OutlineRegion.xy) / _OutlinePicture.xy;
                float scene = limn_Nearness(
                    SAMPLE_TEXTURE2D_LOD(_CameraDepthTexture, sampler_PointClamp, uv, 0).r);
                // Where the surface turns away the camera's depth, which may be that of another
                // place in the pixel, belongs to one farther in.
                float own = max(OwnDepth(inside), OwnDepth(inside - outward * 1.5));
                return scene <= max(own, depth) * 1.001 || scene <= NearestInPixel(inside) * 1.001;
            }
            #endif

            struct StrokeTargets
            {
                float4 coverage : SV_Target0; // by the side that the outline comes from
                float4 edges : SV_Target1;    // what edges correct, 0, 0, coverage by what is seen
            };

            // Which of the sides left, top, right and bottom something comes from that goes in this
            // direction. What goes along an axis comes from both sides of the other axis.
            float4 SidesOf(float2 direction)
            {
                const float alongAxis = -0.17; // sine of 10 degrees
                return step(alongAxis, float4(direction, -direction));
            }

            StrokeTargets StrokeFragment(StrokeVaryings input)
            {
                float2 pixel = input.positionCS.xy;
                float2 whole = input.ends.zw - input.ends.xy;
                float reach = length(whole);
                float2 along = reach > 0.0 ? whole / reach : float2(1.0, 0.0);
                float2 outward = float2(along.y, -along.x);

                float2 from = pixel - input.ends.xy;
                float place = dot(from, along);
                float across = dot(from, outward);
                float onEdge = clamp(place, 0.0, reach);
                float2 apart = from - along * onEdge;
                float away = length(apart);
                float2 direction = away > 1e-4 ? apart / away : outward;
                // Behind the edge of something thin is the outline of its other side.
                bool isBehind = across < 0.0 && OwnDepth(pixel) > 0.0;
                bool isInside = isBehind && place == onEdge;
                float distance = isInside ? -away : away;
                float covered = BoxCoverage(direction, _OutlineWidth - distance);

                float2 nearest = input.ends.xy + along * onEdge;
                float extent = 0.5 * (abs(along.x) + abs(along.y));
                float share = (clamp(place + extent, 0.0, reach) - clamp(place - extent, 0.0, reach)) /
                              (2.0 * extent);
                StrokeTargets output;
                // At round borders the way from the next edges differs, at corners their normals do:
                // only what differs in both comes from another side. What is inside has no side.
                float4 sides = SidesOf(direction) * SidesOf(outward);
                sides = dot(sides, 1.0) > 0.0 ? sides : SidesOf(direction);
                output.coverage = covered * (isBehind ? float4(1.0, 1.0, 0.0, 0.0) : sides);
                output.edges = float4(EdgeCorrection(pixel, nearest, outward, across, share),
                                      0.0, 0.0, covered);
            #if defined(_STROKE_OCCLUSION)
                float depth = lerp(input.depths.x, input.depths.y, onEdge / max(reach, 1e-6));
                output.edges.a = IsVisible(nearest, outward, depth) ? covered : 0.0;
            #endif
                return output;
            }
            ENDHLSL
        }

        Pass // 2: what strokes cover and objects do not, over the camera's colour; alpha is kept
        {
            Name "Composite"
            ZWrite Off
            ZTest Always
            Cull Off
            Blend SrcAlpha OneMinusSrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex TileVertex
            #pragma fragment CompositeFragment

            #pragma shader_feature_local _ _STROKE_OCCLUSION

            TEXTURE2D(_StrokeCoverage);
            TEXTURE2D(_StrokeEdges);
            float4 _Tiles[1022]; // left, top, right, bottom
            half4 _OutlineColor;
            half4 _OccludedColor;

            float4 TileVertex(uint vertexID : SV_VertexID) : SV_POSITION
            {
                float4 tile = _Tiles[vertexID / 6u];
                float2 pixel = lerp(tile.xy, tile.zw, QuadCorner(vertexID));
                return PixelToClip(pixel + _OutlineRegion.xy, _OutlinePicture.xy);
            }

            half4 CompositeFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                float2 pixel = positionCS.xy - _OutlineRegion.xy;
                float2 uv = pixel * _StrokeDepth_TexelSize.xy;
                float4 sides = SAMPLE_TEXTURE2D_LOD(_StrokeCoverage, sampler_PointClamp, uv, 0);
                float4 edges = SAMPLE_TEXTURE2D_LOD(_StrokeEdges, sampler_PointClamp, uv, 0);
                float objects = saturate((OwnDepth(pixel) > 0.0 ? 1.0 : 0.0) + edges.r);
                float largest = max(max(sides.x, sides.y), max(sides.z, sides.w));
                // Outlines that come from opposite sides cover different parts of the pixel.
                float both = min(sides.x + sides.z, sides.y + sides.w);
                float covered = saturate(saturate(max(largest, both)) - objects);
                half4 color = _OutlineColor;
            #if defined(_STROKE_OCCLUSION)
                color = edges.a >= largest ? _OutlineColor : _OccludedColor;
            #endif
                return half4(color.rgb, color.a * covered);
            }
            ENDHLSL
        }
    }
}

// Lines where the brightness of the picture changes; ColorEdgesPass runs the passes in order.
// Technique 3 of the introduction of the article on selection outlines: the gradient of the
// brightness around a pixel, found by convolution, against a threshold.
Shader "Hidden/Limn/ColorEdges"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZWrite Off

        Pass // 0: where the filtered objects are seen
        {
            Name "Mask"
            Tags { "LimnWithinMesh" = "True" }
            ZTest LEqual
            Offset -1, -1 // the depths to compare with come from other programs

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment MaskFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

            float4 MaskVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half MaskFragment() : SV_Target
            {
                return 1;
            }
            ENDHLSL
        }

        Pass // 1: how bright the picture looks, 0...1
        {
            Name "Brightness"
            Tags { "LimnFullScreen" = "0 0 0 0 where _BlitTexture is 0 within 0 texels" }
            ZTest Always

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment BrightnessFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            float BrightnessFragment(Varyings input) : SV_Target
            {
                float3 color =
                    SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, 0).rgb;
                // The screen shows no more than 0...1. NaN is not above 0, so that it ends here.
                color = color > 0.0 ? min(color, 1.0) : 0.0;
                // The root is near to sRGB's curve: a step counts as much as the eye sees of it.
                return sqrt(dot(color, float3(0.2126, 0.7152, 0.0722)));
            }
            ENDHLSL
        }

        Pass // 2: the outline's colour where the brightness changes, blended over the picture
        {
            Name "Edges"
            Tags { "LimnFullScreen" = "0 0 0 0 where _BlitTexture or _ColorEdgesMask or _ColorEdgesColor is 0 within _ColorEdgesReach texels" }
            ZTest Always
            Blend One OneMinusSrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment EdgesFragment
            #pragma multi_compile_local_fragment _ROBERTS _SOBEL _PREWITT
            #pragma multi_compile_local_fragment _ _BETWEEN_TEXELS // taps; else in their middle

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            TEXTURE2D_X(_ColorEdgesMask);
            half4 _ColorEdgesColor;
            float4 _ColorEdgesTaps; // texels: column and row of the first (xy) and the last tap (zw)
            float4 _ColorEdgesRamp; // the step where lines begin, how fast they get stronger

            float Brightness(float2 place)
            {
            #ifdef _BETWEEN_TEXELS
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, place, 0).r;
            #else
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, place, 0).r;
            #endif
            }

            // How much the brightness changes across the taps: a straight step of h gives h.
            float Gradient(float2 center)
            {
                float2 first = center + _BlitTexture_TexelSize.xy * _ColorEdgesTaps.xy;
                float2 last = center + _BlitTexture_TexelSize.xy * _ColorEdgesTaps.zw;
                float corner00 = Brightness(first);
                float corner10 = Brightness(float2(last.x, first.y));
                float corner01 = Brightness(float2(first.x, last.y));
                float corner11 = Brightness(last);
                float rising = corner11 - corner00;
                float falling = corner10 - corner01;
            #ifdef _ROBERTS
                return sqrt((rising * rising + falling * falling) * 0.5);
            #else
                #ifdef _SOBEL
                const float weight = 2.0;
                #else
                const float weight = 1.0;
                #endif
                float2 between = 0.5 * (_ColorEdgesTaps.xy + _ColorEdgesTaps.zw);
                float2 middle = center + _BlitTexture_TexelSize.xy * between;
                float across = Brightness(float2(last.x, middle.y)) -
                               Brightness(float2(first.x, middle.y));
                float along = Brightness(float2(middle.x, last.y)) -
                              Brightness(float2(middle.x, first.y));
                float2 sum = float2(rising + falling, rising - falling);
                return length(sum + weight * float2(across, along)) / (2.0 + weight);
            #endif
            }

            half4 EdgesFragment(Varyings input) : SV_Target
            {
                float above = Gradient(input.texcoord) - _ColorEdgesRamp.x;
                float mask =
                    SAMPLE_TEXTURE2D_X_LOD(_ColorEdgesMask, sampler_PointClamp, input.texcoord, 0).r;
                float strength = saturate(above * _ColorEdgesRamp.y) * mask * _ColorEdgesColor.a;
                return half4(_ColorEdgesColor.rgb * strength, strength);
            }
            ENDHLSL
        }
    }
}

// A line where a mask differs from the mean of its neighbours, in a full-screen pass of five
// samples; MaskDifferenceOutlinePass runs the passes. The arithmetic and the names of the inputs
// follow the article on outlines as post-processing, the text is limn's own:
//
//   t_tex0         the mask: 0 = not outlined, else colour and, in alpha, which object
//   t_tex1         the picture so far; not read with framebuffer fetch
//   t_scene_depth  the depth of the scene, with _CameraDepthTexture's size
//   u_rt_size      size of the mask, texels: width, height, 1 / width, 1 / height
//   width          how far the neighbours are away, texels
//   outline_depth_threshold_clip_player
//                  where the depth is this or more there is no line: 0 near plane, 1 far plane
//
// What t_scene_depth holds: 0 near ... 1 far; with SYSTEM_DEPTH_RANGE_NEGATIVE -1 ... 1; with
// USE_REVERSED_Z the other way round. limn's own depth mostly is. With _NO_DEPTH_CLIP it is
// not read.
Shader "Hidden/Limn/MaskDifferenceOutline"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
        #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
        #define t_scene_depth _CameraDepthTexture

        TEXTURE2D_X(t_tex0);
        float4 u_rt_size;
        float width;
        float outline_depth_threshold_clip_player;

        struct OutlineVaryings
        {
            float4 positionCS : SV_POSITION;
            float2 center : TEXCOORD0;
            float4 upDown : TEXCOORD1;
            float4 leftRight : TEXCOORD2;
        };

        OutlineVaryings OutlineVertex(Attributes input)
        {
            Varyings whole = Vert(input);
            float2 away = u_rt_size.zw * width;
            OutlineVaryings output;
            output.positionCS = whole.positionCS;
            output.center = whole.texcoord;
            output.upDown = whole.texcoord.xyxy + float4(0, -away.y, 0, away.y);
            output.leftRight = whole.texcoord.xyxy + float4(-away.x, 0, away.x, 0);
            return output;
        }

        // Nearest texels: between two objects there is no third one.
        float4 Mask(float2 place)
        {
            return SAMPLE_TEXTURE2D_X_LOD(t_tex0, sampler_PointClamp, place, 0);
        }

        float DepthClip(float2 screen)
        {
        #ifdef _NO_DEPTH_CLIP
            return 1.0;
        #else
            float depth = SAMPLE_TEXTURE2D_X_LOD(t_scene_depth, sampler_PointClamp, screen, 0).r;
        #ifdef SYSTEM_DEPTH_RANGE_NEGATIVE
            depth = depth * 0.5 + 0.5;
        #endif
        #ifdef USE_REVERSED_Z
            depth = 1.0 - depth;
        #endif
            return 1.0 - step(outline_depth_threshold_clip_player, depth);
        #endif
        }

        float3 Outline(OutlineVaryings input, float2 screen)
        {
            float4 center = Mask(input.center);
            float4 up = Mask(input.upDown.xy);
            float4 down = Mask(input.upDown.zw);
            float4 left = Mask(input.leftRight.xy);
            float4 right = Mask(input.leftRight.zw);
            // The sum of four equal floats is exact, so that equal neighbours differ by 0.
            float4 difference = center - (((up + down) + left) + right) * 0.25;
            float edge = sign(length(difference)) * DepthClip(screen);
            float4 color = max(max(up, down), max(left, right));
            return color.rgb * edge;
        }
        ENDHLSL

        Pass // 0: an object in the mask
        {
            Name "Mask"
            Tags { "LimnWithinMesh" = "True" }
            ZTest LEqual
            ZWrite On
            Cull Back

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment MaskFragment

            float4 _MaskValue;

            float4 MaskVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            float4 MaskFragment() : SV_Target
            {
                return _MaskValue;
            }
            ENDHLSL
        }

        Pass // 1: picture and line, the picture as a texture
        {
            Name "Outline"
            Tags { "LimnFullScreen" = "True" }
            ZTest Always
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma vertex OutlineVertex
            #pragma fragment OutlineFragment
            #pragma multi_compile_local_fragment _ SYSTEM_DEPTH_RANGE_NEGATIVE
            #pragma multi_compile_local_fragment _ USE_REVERSED_Z
            #pragma multi_compile_local_fragment _ _NO_DEPTH_CLIP

            TEXTURE2D_X(t_tex1);

            float4 OutlineFragment(OutlineVaryings input) : SV_Target
            {
                float2 screen = input.positionCS.xy * _ScreenSize.zw;
                float4 scene = SAMPLE_TEXTURE2D_X_LOD(t_tex1, sampler_PointClamp, screen, 0);
                return float4(scene.rgb + Outline(input, screen), scene.a);
            }
            ENDHLSL
        }

        Pass // 2: the line alone, added in place to what the framebuffer holds
        {
            Name "Outline Framebuffer Fetch"
            Tags { "LimnFullScreen" = "0 0 0 1 where t_tex0 is 0" }
            ZTest Always
            ZWrite Off
            Cull Off
            Blend One One, Zero One

            HLSLPROGRAM
            #pragma vertex OutlineVertex
            #pragma fragment OutlineFragment
            #pragma multi_compile_local_fragment _ SYSTEM_DEPTH_RANGE_NEGATIVE
            #pragma multi_compile_local_fragment _ USE_REVERSED_Z
            #pragma multi_compile_local_fragment _ _NO_DEPTH_CLIP

            float4 OutlineFragment(OutlineVaryings input) : SV_Target
            {
                return float4(Outline(input, input.positionCS.xy * _ScreenSize.zw), 1);
            }
            ENDHLSL
        }
    }
}

Shader "Hidden/Universal/CoreBlit"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        Pass // _BlitTexture over the whole target, nearest texel
        {
            Name "Nearest"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyNearest

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 CopyNearest(Varyings input) : SV_Target
            {
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, _BlitMipLevel);
            }
            ENDHLSL
        }

        Pass // the same, bilinear
        {
            Name "Bilinear"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyBilinear

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 CopyBilinear(Varyings input) : SV_Target
            {
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, input.texcoord, _BlitMipLevel);
            }
            ENDHLSL
        }

        Pass // to the output: the camera's alpha is no one's business there
        {
            Name "Final"
            Tags { "LimnFullScreen" = "_BlitTexture with alpha 1" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyOpaque

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 CopyOpaque(Varyings input) : SV_Target
            {
                half4 color = SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, 0);
                return half4(color.rgb, 1);
            }
            ENDHLSL
        }

        Pass // a depth texture to a colour texture of one channel
        {
            Name "Depth"
            Tags { "LimnFullScreen" = "_BlitTexture with alpha 1" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyDepth

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            float4 CopyDepth(Varyings input) : SV_Target
            {
                float depth = SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, 0).r;
                return float4(depth, 0, 0, 1);
            }
            ENDHLSL
        }

        Pass // world-space normals and depth to what the built-in pipeline has of both
        {
            Name "DepthNormals"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment EncodeDepthNormals

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
            #include "limn/BuiltinEncoding.hlsl"

            float4 EncodeDepthNormals(Varyings input) : SV_Target
            {
                float3 normalWS =
                    SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, 0).xyz;
                if (dot(normalWS, normalWS) < 0.25)
                {
                    return float4(0.5, 0.5, 1.0, 1.0); // nothing was drawn: towards the camera, far
                }
                float depth = SampleSceneDepth(input.texcoord);
                float eyeDepth = IsPerspectiveProjection()
                                     ? LinearEyeDepth(depth, _ZBufferParams)
                                     : lerp(_ProjectionParams.z, _ProjectionParams.y,
                                            limn_Nearness(depth));
                float3 normalVS = normalize(mul((float3x3)UNITY_MATRIX_V, normalWS));
                normalVS.z = max(normalVS.z, -0.75); // one away from the camera has no place there
                return EncodeDepthNormal(eyeDepth * _ProjectionParams.w, normalVS);
            }
            ENDHLSL
        }

        Pass // "Final" of a texture of another size
        {
            Name "FinalBilinear"
            Tags { "LimnFullScreen" = "_BlitTexture with alpha 1" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyOpaqueBilinear

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 CopyOpaqueBilinear(Varyings input) : SV_Target
            {
                half4 color = SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, input.texcoord, 0);
                return half4(color.rgb, 1);
            }
            ENDHLSL
        }

        Pass // _BlitTexture over a part of the target
        {
            Name "NearestQuad"

            HLSLPROGRAM
            #pragma vertex VertQuad
            #pragma fragment FragNearest

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
            ENDHLSL
        }

        Pass // the same, bilinear
        {
            Name "BilinearQuad"

            HLSLPROGRAM
            #pragma vertex VertQuad
            #pragma fragment FragBilinear

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
            ENDHLSL
        }

        Pass // "Bilinear" with the depth of another texture
        {
            Name "ColorAndDepth"
            ZWrite On

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyColorAndDepth

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            TEXTURE2D_FLOAT(_InputDepthTexture);

            void CopyColorAndDepth(Varyings input, out float4 color : SV_Target, out float depth : SV_Depth)
            {
                color = SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, input.texcoord, _BlitMipLevel);
                depth = SAMPLE_TEXTURE2D_LOD(_InputDepthTexture, sampler_PointClamp, input.texcoord, _BlitMipLevel).r;
            }
            ENDHLSL
        }
    }
}

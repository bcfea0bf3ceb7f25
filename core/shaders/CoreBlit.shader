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
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, 0);
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
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, input.texcoord, 0);
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
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CopyDepth

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            float4 CopyDepth(Varyings input) : SV_Target
            {
                return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, input.texcoord, 0).r;
            }
            ENDHLSL
        }
    }
}

// How much of the ambient light around a pixel what is near it hides, from depth and normals.
// Source: the estimator of "The Alchemy Screen-Space Ambient Obscurance Algorithm" (McGuire, Osman,
// Bukowski, Hennessy 2011), with URP's parameters; it stands in SSAO.hlsl of the library.
Shader "Hidden/Universal Render Pipeline/ScreenSpaceAmbientOcclusion"
{
    HLSLINCLUDE
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
    #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/SSAO.hlsl"

    // As far away as the sky, so that a depth test finds out where that is.
    Varyings FarVertex(Attributes input)
    {
        Varyings output = Vert(input);
        output.positionCS.z = UNITY_RAW_FAR_CLIP_VALUE * output.positionCS.w;
        return output;
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        Pass // 0: what is hidden, and the normal for the blur
        {
            Name "SSAO_Occlusion"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment SSAO
            #pragma multi_compile_local_fragment _BLUE_NOISE _INTERLEAVED_GRADIENT
            #pragma multi_compile_local_fragment _SOURCE_DEPTH_LOW _SOURCE_DEPTH_MEDIUM _SOURCE_DEPTH_HIGH _SOURCE_DEPTH_NORMALS
            #pragma multi_compile_local_fragment _SAMPLE_COUNT_LOW _SAMPLE_COUNT_MEDIUM _SAMPLE_COUNT_HIGH
            #pragma multi_compile_local_fragment _ _ORTHOGRAPHIC
            ENDHLSL
        }

        Pass // 1
        {
            Name "SSAO_Bilateral_HorizontalBlur"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment HorizontalBlur
            ENDHLSL
        }

        Pass // 2
        {
            Name "SSAO_Bilateral_VerticalBlur"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment VerticalBlur
            ENDHLSL
        }

        Pass // 3: the blur's end, from here on how much light is left
        {
            Name "SSAO_Bilateral_FinalBlur"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment FinalBlur
            ENDHLSL
        }

        Pass // 4: the same, over the picture
        {
            Name "SSAO_Bilateral_FinalBlur_AfterOpaque"
            ZTest NotEqual
            Blend Zero SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex FarVertex
            #pragma fragment OverPictureFragment

            half4 OverPictureFragment(Varyings input) : SV_Target
            {
                half4 left = FinalBlur(input);
                return half4(0.0, 0.0, 0.0, left.r);
            }
            ENDHLSL
        }

        Pass // 5
        {
            Name "SSAO_Gaussian_HorizontalBlur"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment HorizontalGaussianBlur
            ENDHLSL
        }

        Pass // 6
        {
            Name "SSAO_Gaussian_VerticalBlur"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment VerticalGaussianBlur
            ENDHLSL
        }

        Pass // 7
        {
            Name "SSAO_Gaussian_VerticalBlur_AfterOpaque"
            ZTest NotEqual
            Blend Zero SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex FarVertex
            #pragma fragment OverPictureFragment

            half4 OverPictureFragment(Varyings input) : SV_Target
            {
                half left = VerticalGaussianBlur(input);
                return half4(0.0, 0.0, 0.0, left);
            }
            ENDHLSL
        }

        Pass // 8
        {
            Name "SSAO_Kawase"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment KawaseBlur
            ENDHLSL
        }

        Pass // 9
        {
            Name "SSAO_Kawase_AfterOpaque"
            ZTest NotEqual
            Blend Zero SrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex FarVertex
            #pragma fragment OverPictureFragment

            half4 OverPictureFragment(Varyings input) : SV_Target
            {
                half left = KawaseBlur(input);
                return half4(0.0, 0.0, 0.0, left);
            }
            ENDHLSL
        }
    }
}

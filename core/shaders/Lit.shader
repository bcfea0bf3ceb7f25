// URP's physically based shader: the names are Unity's (2022.3), the lighting is that of the
// ShaderLibrary. The Toggle attributes choose for scene files what Unity's inspector chooses there.
Shader "Universal Render Pipeline/Lit"
{
    Properties
    {
        [ToggleOff(_SPECULAR_SETUP)] _WorkflowMode ("Metallic rather than specular", Float) = 1

        [MainTexture] _BaseMap ("Albedo", 2D) = "white" {}
        [MainColor] _BaseColor ("Color", Color) = (1, 1, 1, 1)
        _Cutoff ("Alpha of the cut", Range(0, 1)) = 0.5

        _Smoothness ("Smoothness", Range(0, 1)) = 0.5
        [Toggle(_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A)] _SmoothnessTextureChannel ("Smoothness in the albedo's alpha", Float) = 0
        _Metallic ("Metallic", Range(0, 1)) = 0
        _MetallicGlossMap ("Metallic (R), smoothness (A)", 2D) = "white" {}
        _SpecColor ("Specular", Color) = (0.2, 0.2, 0.2, 1)
        _SpecGlossMap ("Specular (RGB), smoothness (A)", 2D) = "white" {}
        [ToggleOff] _SpecularHighlights ("Highlights", Float) = 1
        [ToggleOff] _EnvironmentReflections ("Reflections", Float) = 1

        _BumpScale ("Strength of the normal map", Float) = 1
        _BumpMap ("Normal map", 2D) = "bump" {}
        _Parallax ("Depth of the height map", Range(0.005, 0.08)) = 0.005
        _ParallaxMap ("Height (G)", 2D) = "black" {}
        _OcclusionStrength ("Strength of the occlusion", Range(0, 1)) = 1
        _OcclusionMap ("Occlusion (G)", 2D) = "white" {}
        [HDR] _EmissionColor ("Emission", Color) = (0, 0, 0, 1)
        _EmissionMap ("Emission", 2D) = "white" {}

        _DetailMask ("Where details are (A)", 2D) = "white" {}
        _DetailAlbedoMapScale ("Strength of the detail albedo", Range(0, 2)) = 1
        _DetailAlbedoMap ("Detail albedo, times 2", 2D) = "linearGrey" {}
        _DetailNormalMapScale ("Strength of the detail normal map", Range(0, 2)) = 1
        [Normal] _DetailNormalMap ("Detail normal map", 2D) = "bump" {}

        [Toggle(_SURFACE_TYPE_TRANSPARENT)] _Surface ("Transparent", Float) = 0
        _Blend ("Blending: alpha, premultiplied, additive, multiply", Float) = 0
        _Cull ("Culled faces", Float) = 2
        [Toggle(_ALPHATEST_ON)] _AlphaClip ("Cut by alpha", Float) = 0
        _SrcBlend ("Source factor", Float) = 1
        _DstBlend ("Destination factor", Float) = 0
        _SrcBlendAlpha ("Source factor of alpha", Float) = 1
        _DstBlendAlpha ("Destination factor of alpha", Float) = 0
        _ZWrite ("Depth write", Float) = 1
        _BlendModePreserveSpecular ("Highlights as strong as on opaque surfaces", Float) = 1
        _AlphaToMask ("Alpha to mask", Float) = 0
        [ToggleOff(_RECEIVE_SHADOWS_OFF)] _ReceiveShadows ("Shows shadows", Float) = 1
        _QueueOffset ("Place in the queue", Float) = 0
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "RenderPipeline" = "UniversalPipeline" "UniversalMaterialType" = "Lit" "IgnoreProjector" = "True" }

        Pass
        {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }
            Blend [_SrcBlend] [_DstBlend], [_SrcBlendAlpha] [_DstBlendAlpha]
            ZWrite [_ZWrite]
            Cull [_Cull]
            AlphaToMask [_AlphaToMask]

            HLSLPROGRAM
            #pragma vertex LitPassVertex
            #pragma fragment LitPassFragment
            #pragma shader_feature_local _NORMALMAP
            #pragma shader_feature_local _PARALLAXMAP
            #pragma shader_feature_local _RECEIVE_SHADOWS_OFF
            #pragma shader_feature_local _ _DETAIL_MULX2 _DETAIL_SCALED
            #pragma shader_feature_local_fragment _SURFACE_TYPE_TRANSPARENT
            #pragma shader_feature_local_fragment _ALPHATEST_ON
            #pragma shader_feature_local_fragment _ _ALPHAPREMULTIPLY_ON _ALPHAMODULATE_ON
            #pragma shader_feature_local_fragment _EMISSION
            #pragma shader_feature_local_fragment _METALLICSPECGLOSSMAP
            #pragma shader_feature_local_fragment _SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A
            #pragma shader_feature_local_fragment _OCCLUSIONMAP
            #pragma shader_feature_local_fragment _SPECULARHIGHLIGHTS_OFF
            #pragma shader_feature_local_fragment _ENVIRONMENTREFLECTIONS_OFF
            #pragma shader_feature_local_fragment _SPECULAR_SETUP
            #include_with_pragmas "limn/LightVariants.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitForwardPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ColorMask 0
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex ShadowPassVertex
            #pragma fragment ShadowPassFragment
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local_fragment _SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/ShadowCasterPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ColorMask R
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex DepthOnlyVertex
            #pragma fragment DepthOnlyFragment
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local_fragment _SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/DepthOnlyPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormals" }
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex DepthNormalsVertex
            #pragma fragment DepthNormalsFragment
            #pragma shader_feature_local _NORMALMAP
            #pragma shader_feature_local _ _DETAIL_MULX2 _DETAIL_SCALED
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local_fragment _SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitDepthNormalsPass.hlsl"
            ENDHLSL
        }

        Pass
        {
            Name "Meta"
            Tags { "LightMode" = "Meta" }
            Cull Off

            HLSLPROGRAM
            #pragma vertex UniversalVertexMeta
            #pragma fragment UniversalFragmentMetaLit
            #pragma shader_feature_local_fragment _ALPHATEST_ON
            #pragma shader_feature_local_fragment _EMISSION
            #pragma shader_feature_local_fragment _METALLICSPECGLOSSMAP
            #pragma shader_feature_local_fragment _SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A
            #pragma shader_feature_local_fragment _SPECULAR_SETUP
            #pragma shader_feature_local_fragment _ _DETAIL_MULX2 _DETAIL_SCALED
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/LitMetaPass.hlsl"
            ENDHLSL
        }
    }
}

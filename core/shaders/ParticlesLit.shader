// URP's physically based shader of particles under Unity's names (2022.3).
Shader "Universal Render Pipeline/Particles/Lit"
{
    Properties
    {
        [MainTexture] _BaseMap ("Albedo", 2D) = "white" {}
        [MainColor] _BaseColor ("Color", Color) = (1, 1, 1, 1)
        _Cutoff ("Alpha of the cut", Range(0, 1)) = 0.5

        _Metallic ("Metallic", Range(0, 1)) = 0
        _Smoothness ("Smoothness", Range(0, 1)) = 0.5
        _MetallicGlossMap ("Metallic (R), smoothness (A)", 2D) = "white" {}
        _BumpScale ("Strength of the normal map", Float) = 1
        _BumpMap ("Normal map", 2D) = "bump" {}
        [HDR] _EmissionColor ("Emission", Color) = (0, 0, 0, 1)
        _EmissionMap ("Emission", 2D) = "white" {}

        [Toggle(_SOFTPARTICLES_ON)] _SoftParticlesEnabled ("Soft particles", Float) = 0
        _SoftParticlesNearFadeDistance ("Soft particles: near distance", Float) = 0
        _SoftParticlesFarFadeDistance ("Soft particles: far distance", Float) = 1
        _SoftParticleFadeParams ("Near distance, 1 / (far - near)", Vector) = (0, 0, 0, 0)
        [Toggle(_FADING_ON)] _CameraFadingEnabled ("Fading by distance", Float) = 0
        _CameraNearFadeDistance ("Fading: near distance", Float) = 1
        _CameraFarFadeDistance ("Fading: far distance", Float) = 2
        _CameraFadeParams ("Near distance, 1 / (far - near)", Vector) = (0, 0, 0, 0)
        [Toggle(_DISTORTION_ON)] _DistortionEnabled ("Distortion", Float) = 0
        _DistortionBlend ("Distorted rather than own colour", Range(0, 1)) = 0.5
        _DistortionStrength ("Strength of the distortion", Float) = 1
        _DistortionStrengthScaled ("A tenth of it", Float) = 0.1
        [Toggle(_FLIPBOOKBLENDING_ON)] _FlipbookBlending ("Frames of a flip book fade", Float) = 0
        _ColorMode ("Multiply, add, subtract, overlay, color, difference", Float) = 0
        _BaseColorAddSubDiff ("How the color mode adds", Vector) = (0, 0, 0, 0)

        [Toggle(_SURFACE_TYPE_TRANSPARENT)] _Surface ("Transparent", Float) = 0
        _Blend ("Blending: alpha, premultiplied, additive, multiply", Float) = 0
        _Cull ("Culled faces", Float) = 2
        [Toggle(_ALPHATEST_ON)] _AlphaClip ("Cut by alpha", Float) = 0
        [ToggleOff(_RECEIVE_SHADOWS_OFF)] _ReceiveShadows ("Shows shadows", Float) = 1
        _BlendOp ("Blend operation", Float) = 0
        _SrcBlend ("Source factor", Float) = 1
        _DstBlend ("Destination factor", Float) = 0
        _SrcBlendAlpha ("Source factor of alpha", Float) = 1
        _DstBlendAlpha ("Destination factor of alpha", Float) = 0
        _ZWrite ("Depth write", Float) = 1
        _AlphaToMask ("Alpha to mask", Float) = 0
        _QueueOffset ("Place in the queue", Float) = 0
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "RenderPipeline" = "UniversalPipeline" "UniversalMaterialType" = "Lit" "IgnoreProjector" = "True" }

        Pass
        {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }
            BlendOp [_BlendOp]
            Blend [_SrcBlend] [_DstBlend], [_SrcBlendAlpha] [_DstBlendAlpha]
            ZWrite [_ZWrite]
            Cull [_Cull]
            AlphaToMask [_AlphaToMask]

            HLSLPROGRAM
            #pragma vertex ParticlesLitVertex
            #pragma fragment ParticlesLitFragment
            #pragma shader_feature_local _FLIPBOOKBLENDING_ON
            #pragma shader_feature_local _NORMALMAP
            #pragma shader_feature_local _SOFTPARTICLES_ON
            #pragma shader_feature_local _FADING_ON
            #pragma shader_feature_local _DISTORTION_ON
            #pragma shader_feature_local_fragment _EMISSION
            #pragma shader_feature_local_fragment _SURFACE_TYPE_TRANSPARENT
            #pragma shader_feature_local_fragment _ALPHATEST_ON
            #pragma shader_feature_local_fragment _ _ALPHAPREMULTIPLY_ON _ALPHAMODULATE_ON
            #pragma shader_feature_local_fragment _ _COLOROVERLAY_ON _COLORCOLOR_ON _COLORADDSUBDIFF_ON
            #pragma shader_feature_local_fragment _METALLICSPECGLOSSMAP
            #pragma shader_feature_local _RECEIVE_SHADOWS_OFF
            #pragma shader_feature_local_fragment _SPECULARHIGHLIGHTS_OFF
            #pragma shader_feature_local_fragment _ENVIRONMENTREFLECTIONS_OFF
            #include_with_pragmas "limn/LightVariants.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesLitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesLitForwardPass.hlsl"
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
            #pragma shader_feature_local _FLIPBOOKBLENDING_ON
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local_fragment _ _COLOROVERLAY_ON _COLORCOLOR_ON _COLORADDSUBDIFF_ON
            #include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesLitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesDepthOnlyPass.hlsl"
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
            #pragma shader_feature_local _FLIPBOOKBLENDING_ON
            #pragma shader_feature_local _ALPHATEST_ON
            #pragma shader_feature_local_fragment _ _COLOROVERLAY_ON _COLORCOLOR_ON _COLORADDSUBDIFF_ON
            #include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesLitInput.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/Particles/ParticlesDepthNormalsPass.hlsl"
            ENDHLSL
        }
    }
}

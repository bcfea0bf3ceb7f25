// One directional light with half-Lambert wrap, a Blinn-Phong highlight and a two-sided ambient:
// enough to read shapes by, and cheap. Objects of scene files that name no shader have it.
Shader "Limn/Half Lambert"
{
    Properties
    {
        [MainTexture] _BaseMap ("Texture", 2D) = "white" {}
        [MainColor] _BaseColor ("Color", Color) = (1, 1, 1, 1)
        _Smoothness ("Smoothness", Range(0, 1)) = 0.3
        [HDR] _EmissionColor ("Emission", Color) = (0, 0, 0, 1)
        _SrcBlend ("Source factor", Float) = 1
        _DstBlend ("Destination factor", Float) = 0
        _SrcBlendAlpha ("Source factor of alpha", Float) = 1
        _DstBlendAlpha ("Destination factor of alpha", Float) = 0
        _ZWrite ("Depth write", Float) = 1
        _Cull ("Culled faces", Float) = 2
        [ToggleOff(_RECEIVE_SHADOWS_OFF)] _ReceiveShadows ("Shows shadows", Float) = 1
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" "RenderPipeline" = "UniversalPipeline" }

        Pass
        {
            Name "ForwardLit"
            Tags { "LightMode" = "UniversalForward" }
            Blend [_SrcBlend] [_DstBlend], [_SrcBlendAlpha] [_DstBlendAlpha]
            ZWrite [_ZWrite]
            Cull [_Cull]

            HLSLPROGRAM
            #pragma vertex LitVertex
            #pragma fragment LitFragment
            #pragma multi_compile _ _ADDITIONAL_LIGHTS
            #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE
            #pragma multi_compile_fragment _ _ADDITIONAL_LIGHT_SHADOWS
            #pragma multi_compile_fragment _ _SHADOWS_SOFT
            #pragma shader_feature_local _RECEIVE_SHADOWS_OFF

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

            TEXTURE2D(_BaseMap);
            SAMPLER(sampler_BaseMap);

            CBUFFER_START(UnityPerMaterial)
            float4 _BaseMap_ST;
            half4 _BaseColor;
            half4 _EmissionColor;
            half _Smoothness;
            CBUFFER_END

            struct Attributes
            {
                float4 positionOS : POSITION;
                float3 normalOS : NORMAL;
                float2 uv : TEXCOORD0;
            };
            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float2 uv : TEXCOORD0;
                float3 normalWS : TEXCOORD1;
                float3 viewDirWS : TEXCOORD2;
            #if defined(_ADDITIONAL_LIGHTS) || defined(MAIN_LIGHT_CALCULATE_SHADOWS)
                float3 position : TEXCOORD3; // relative to limn_Origin
            #endif
            };

            Varyings LitVertex(Attributes input)
            {
                Varyings output;
                output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
                output.uv = TRANSFORM_TEX(input.uv, _BaseMap);
                output.normalWS = TransformObjectToWorldNormal(input.normalOS);
                output.viewDirWS = limn_ObjectToWorldSpaceViewDir(input.positionOS.xyz);
            #if defined(_ADDITIONAL_LIGHTS) || defined(MAIN_LIGHT_CALCULATE_SHADOWS)
                output.position = limn_ObjectToRelative(input.positionOS.xyz);
            #endif
                return output;
            }

            half Highlight(float3 normal, float3 toLight, float3 view)
            {
                float3 halfway = SafeNormalize(toLight + view);
                half exponent = exp2(10.0 * _Smoothness + 1.0);
                return pow(saturate(dot(normal, halfway)), exponent) * _Smoothness * 0.25;
            }

            half4 LitFragment(Varyings input) : SV_Target
            {
                half4 albedo = SAMPLE_TEXTURE2D(_BaseMap, sampler_BaseMap, input.uv) * _BaseColor;
                float3 normal = SafeNormalize(input.normalWS);
                float3 view = SafeNormalize(input.viewDirWS);
                Light light = GetMainLight();

                half wrapped = dot(normal, light.direction) * 0.5 + 0.5;
                half3 ambient = SampleSH(normal) * (0.75 + 0.25 * normal.y);
                half3 lambert = light.color * wrapped * wrapped;
                half3 shining = light.color;
            #ifdef MAIN_LIGHT_CALCULATE_SHADOWS
                half shadow = MainLightRealtimeShadow(limn_RelativeToShadowCoord(input.position));
                half lit = lerp(shadow, 1.0, limn_ShadowFade(input.viewDirWS));
                // No darker than where the surface turns away: half-Lambert goes on beyond that.
                lambert = lerp(min(lambert, light.color * 0.25), lambert, lit);
                shining *= lit;
            #endif
                half3 color = albedo.rgb * (lambert + ambient);

                color += shining * Highlight(normal, light.direction, view) + _EmissionColor.rgb;
            #ifdef _ADDITIONAL_LIGHTS
                for (int i = 0; i < GetAdditionalLightsCount(); i++)
                {
                    Light other = limn_GetAdditionalLightRelative(i, input.position);
                    half lambert = saturate(dot(normal, other.direction));
                    half lit = other.distanceAttenuation * other.shadowAttenuation;
                    color += other.color * lit * lambert *
                             (albedo.rgb + Highlight(normal, other.direction, view));
                }
            #endif
                return half4(color, albedo.a);
            }
            ENDHLSL
        }

        UsePass "Universal Render Pipeline/Lit/SHADOWCASTER"
        UsePass "Universal Render Pipeline/Lit/DEPTHONLY"
        UsePass "Universal Render Pipeline/Lit/DEPTHNORMALS"
        UsePass "Universal Render Pipeline/Lit/META"
    }
}

// All effects that look at one pixel, in one pass: glow, vignette, grading, tonemapping.
Shader "Hidden/Universal Render Pipeline/UberPost"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        Pass
        {
            Name "UberPost"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment UberFragment
            #pragma multi_compile_local_fragment _ _BLOOM_LQ _BLOOM_HQ
            #pragma multi_compile_local_fragment _ _BLOOM_DIRT
            #pragma multi_compile_local_fragment _ _VIGNETTE
            #pragma multi_compile_local_fragment _ _COLOR_ADJUSTMENTS
            #pragma multi_compile_local_fragment _ _HDR_GRADING
            #pragma multi_compile_local_fragment _ _TONEMAP_ACES _TONEMAP_NEUTRAL

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Filtering.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/PostProcessing/Common.hlsl"

            TEXTURE2D_X(_Bloom_Texture);
            float4 _Bloom_Texture_TexelSize;
            TEXTURE2D(_LensDirt_Texture);
            float4 _Bloom_Params;      // rgb: strength of the glow's channels, a: of the dirt
            float4 _LensDirt_Params;   // scale (xy), offset (zw) of its uv
            float4 _Vignette_Params1;  // rgb: colour, a: how many times faster it fades along u
            float4 _Vignette_Params2;  // xy: centre, z: intensity, w: smoothness
            float4 _ColorFilter;       // rgb: factors
            float4 _HueSatCon;         // turns added to the hue, factors of saturation and contrast
            float _PostExposure;       // a factor

            float3 Glow(float2 uv)
            {
            #if defined(_BLOOM_HQ)
                float3 bloom = SampleTexture2DBicubic(TEXTURE2D_X_ARGS(_Bloom_Texture, sampler_LinearClamp), uv,
                    _Bloom_Texture_TexelSize.zwxy, float2(1.0, 1.0), 0).rgb;
            #else
                float3 bloom = SAMPLE_TEXTURE2D_X_LOD(_Bloom_Texture, sampler_LinearClamp, uv, 0).rgb;
            #endif
            #ifdef UNITY_COLORSPACE_GAMMA
                bloom *= bloom; // Bloom.shader keeps the root
            #endif
                bloom *= _Bloom_Params.rgb;
            #ifdef _BLOOM_DIRT
                float3 dirt = SAMPLE_TEXTURE2D_LOD(_LensDirt_Texture, sampler_LinearClamp,
                    uv * _LensDirt_Params.xy + _LensDirt_Params.zw, 0).rgb;
                bloom += bloom * dirt * _Bloom_Params.a;
            #endif
                return bloom;
            }

            // Contrast is a slope in a logarithm around middle grey. What comes out is in ACEScg for
            // ACES before tonemapping.
            float3 Contrast(float3 color)
            {
            #if defined(_HDR_GRADING) && defined(_TONEMAP_ACES)
                float3 encoded = ACES_to_ACEScc(unity_to_ACES(color));
                encoded = (encoded - ACEScc_MIDGRAY) * _HueSatCon.z + ACEScc_MIDGRAY;
                return ACES_to_ACEScg(ACEScc_to_ACES(encoded));
            #else
                float3 encoded = LinearToLogC(color);
                encoded = (encoded - ACEScc_MIDGRAY) * _HueSatCon.z + ACEScc_MIDGRAY;
                return LogCToLinear(encoded);
            #endif
            }

            float3 Adjust(float3 color)
            {
                color = max(Contrast(color) * _ColorFilter.rgb, 0.0);
                float3 hsv = RgbToHsv(color);
                hsv.x = RotateHue(hsv.x + _HueSatCon.x, 0.0, 1.0);
                color = HsvToRgb(hsv);
            #ifdef _HDR_GRADING
                float grey = GetLuminance(color);
            #else
                float grey = Luminance(color);
            #endif
                return max(lerp(grey.xxx, color, _HueSatCon.y), 0.0);
            }

            // URP looks both up in a table of 32 x 32 x 32; here they are worked out.
            float3 Grade(float3 color)
            {
            #if !defined(_HDR_GRADING)
                color = ApplyTonemap(color);
                #ifdef _COLOR_ADJUSTMENTS
                color = saturate(Adjust(color));
                #endif
                return color;
            #else
                color = min(color, LogCToLinear(1.0)); // where the table ends
                #if defined(_COLOR_ADJUSTMENTS)
                color = Adjust(color);
                    #if defined(_TONEMAP_ACES)
                return saturate(AcesTonemap(ACEScg_to_ACES(color)));
                    #endif
                #endif
                return ApplyTonemap(color);
            #endif
            }

            float4 UberFragment(Varyings input) : SV_Target
            {
                float2 uv = input.texcoord;
                float3 color = SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, uv, 0).rgb;
                color = color > 0.0 ? min(color, HALF_MAX) : 0.0; // NaN is not above 0
            #ifdef UNITY_COLORSPACE_GAMMA
                color = GetSRGBToLinear(color); // effects are linear in both colour spaces
            #endif
            #if defined(_BLOOM_LQ) || defined(_BLOOM_HQ)
                color += Glow(uv);
            #endif
            #ifdef _VIGNETTE
                color = ApplyVignette(color, uv, _Vignette_Params2.xy, _Vignette_Params2.z, _Vignette_Params1.w,
                                      _Vignette_Params2.w, _Vignette_Params1.rgb);
            #endif
                color = Grade(color * _PostExposure);
            #ifdef UNITY_COLORSPACE_GAMMA
                color = GetLinearToSRGB(color);
            #endif
                return float4(color, 1.0);
            }
            ENDHLSL
        }
    }
}

// The glow of what is bright: pictures of halved sizes, each blurred, added up from the smallest.
Shader "Hidden/Universal Render Pipeline/Bloom"
{
    HLSLINCLUDE
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
    #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Filtering.hlsl"
    #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

    float4 _Params; // scatter, clamp, threshold (linear), half of it

    half3 Source(float2 uv)
    {
        return SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_LinearClamp, uv, 0).rgb;
    }

    // In gamma space the pictures of the glow keep roots, as URP's do.
    half4 Encode(half3 glow)
    {
    #ifdef UNITY_COLORSPACE_GAMMA
        glow = sqrt(glow);
    #endif
        return half4(glow, 1.0);
    }
    half3 Decode(half3 encoded)
    {
    #ifdef UNITY_COLORSPACE_GAMMA
        encoded *= encoded;
    #endif
        return encoded;
    }
    half3 Glow(float2 uv) { return Decode(Source(uv)); }

    // From 0 a knee below the threshold, all of it a knee above.
    half3 Bright(half3 color)
    {
        color = color > 0.0 ? min(color, _Params.y) : 0.0; // NaN is not above 0
        half brightness = Max3(color.r, color.g, color.b);
        half soft = clamp(brightness - _Params.z + _Params.w, 0.0, 2.0 * _Params.w);
        soft = soft * soft / (4.0 * _Params.w + 1e-4);
        return color * (max(brightness - _Params.z, soft) / max(brightness, 1e-4));
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        Pass // 0: what is bright
        {
            Name "Bloom Prefilter"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment PrefilterFragment
            #pragma multi_compile_local_fragment _ _BLOOM_HQ

            // Five overlapping boxes of four, the middle one as much as the others together
            // (Jimenez 2014), so that a bright texel does not flicker when it moves.
            half3 Boxes(float2 uv)
            {
                float2 texel = _BlitTexture_TexelSize.xy;
                half3 sum = 0.0;
                for (int i = 0; i < 4; i++)
                {
                    float2 corner = float2(i % 2, i / 2) * 2.0 - 1.0;
                    sum += 0.125 * Source(uv + texel * corner * 0.5);
                    sum += 0.03125 * Source(uv + texel * corner);
                    sum += 0.0625 * Source(uv + texel * (i < 2 ? float2(corner.x, 0.0)
                                                               : float2(0.0, i * 2.0 - 5.0)));
                }
                return sum + 0.125 * Source(uv);
            }

            half4 PrefilterFragment(Varyings input) : SV_Target
            {
            #ifdef _BLOOM_HQ
                return Encode(Bright(Boxes(input.texcoord)));
            #else
                return Encode(Bright(Source(input.texcoord)));
            #endif
            }
            ENDHLSL
        }

        Pass // 1: half the size, along u: nine taps of a bell curve
        {
            Name "Bloom Blur Horizontal"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment HorizontalFragment

            half4 HorizontalFragment(Varyings input) : SV_Target
            {
                static const float weights[5] = {0.22702703, 0.19459459, 0.12162162, 0.05405405, 0.01621622};
                float texel = _BlitTexture_TexelSize.x * 2.0;
                half3 sum = weights[0] * Glow(input.texcoord);
                for (int i = 1; i < 5; i++)
                {
                    float2 aside = float2(texel * i, 0.0);
                    sum += weights[i] * (Glow(input.texcoord - aside) + Glow(input.texcoord + aside));
                }
                return Encode(sum);
            }
            ENDHLSL
        }

        Pass // 2: along v: the same curve in five taps, each between two texels
        {
            Name "Bloom Blur Vertical"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment VerticalFragment

            half4 VerticalFragment(Varyings input) : SV_Target
            {
                float2 near = float2(0.0, 1.38461538 * _BlitTexture_TexelSize.y);
                float2 far = float2(0.0, 3.23076923 * _BlitTexture_TexelSize.y);
                half3 sum = 0.22702703 * Glow(input.texcoord);
                sum += 0.31621622 * (Glow(input.texcoord - near) + Glow(input.texcoord + near));
                sum += 0.07027027 * (Glow(input.texcoord - far) + Glow(input.texcoord + far));
                return Encode(sum);
            }
            ENDHLSL
        }

        Pass // 3: a picture and the sum of the smaller ones
        {
            Name "Bloom Upsample"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment UpsampleFragment
            #pragma multi_compile_local_fragment _ _BLOOM_HQ

            TEXTURE2D_X(_SourceTexLowMip);
            float4 _SourceTexLowMip_TexelSize;

            half4 UpsampleFragment(Varyings input) : SV_Target
            {
            #ifdef _BLOOM_HQ
                half3 low = SampleTexture2DBicubic(TEXTURE2D_X_ARGS(_SourceTexLowMip, sampler_LinearClamp),
                    input.texcoord, _SourceTexLowMip_TexelSize.zwxy, float2(1.0, 1.0), 0).rgb;
            #else
                half3 low = SAMPLE_TEXTURE2D_X_LOD(_SourceTexLowMip, sampler_LinearClamp, input.texcoord, 0).rgb;
            #endif
                return Encode(lerp(Glow(input.texcoord), Decode(low), _Params.x));
            }
            ENDHLSL
        }
    }
}

// The article's three steps: selected objects in one colour each, that picture blurred outwards,
// and both laid over the camera's. Arithmetic follows the article, the text is limn's own.
Shader "Hidden/Limn/SelectionOutline"
{
    HLSLINCLUDE
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

    TEXTURE2D(_MainTex);
    SAMPLER(sampler_MainTex);

    struct BlitInput // as CommandBuffer::Blit gives it
    {
        float4 positionOS : POSITION;
        float2 uv : TEXCOORD0;
    };
    struct BlitVaryings
    {
        float4 positionCS : SV_POSITION;
        float2 uv : TEXCOORD0;
    };

    BlitVaryings BlitVertex(BlitInput input)
    {
        BlitVaryings output;
        output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
        output.uv = input.uv;
        return output;
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }

        Pass // 0: an object in its colour, whatever stands in front of it
        {
            Name "Stencil"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex StencilVertex
            #pragma fragment StencilFragment

            float _StartTime;    // twice the seconds at which it was selected
            float _VaryingColor; // not 0: colour and alpha of the moment
            half4 _OutlineColor; // else this

            float4 StencilVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half4 StencilFragment() : SV_Target
            {
                if (_VaryingColor != 0)
                {
                    float s, c;
                    sincos(_Time.z - _StartTime, s, c);
                    return half4(1 + s, 1 + c, 1 - s, 1 - c);
                }
                // What is black counts as outside; this is as near to it as the texture has.
                return half4(max(_OutlineColor.rgb, 1.0 / 255.0), _OutlineColor.a);
            }
            ENDHLSL
        }

        Pass // 1: of four texels around, the largest colour and the mean alpha
        {
            Name "Blur"
            Tags { "LimnFullScreen" = "0 0 0 0 where _MainTex is 0 within _OffsetScale texels" }

            ZTest Always
            Cull Off
            ZWrite Off

            HLSLPROGRAM
            #pragma vertex BlitVertex
            #pragma fragment BlurFragment

            float4 _MainTex_TexelSize;
            half _OffsetScale; // texels, along both axes

            half4 BlurFragment(BlitVaryings input) : SV_Target
            {
                float2 offset = _MainTex_TexelSize.xy * _OffsetScale;
                half4 a = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv - offset);
                half4 b = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv + float2(offset.x, -offset.y));
                half4 c = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv + offset);
                half4 d = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv + float2(-offset.x, offset.y));
                return half4(max(max(a.rgb, b.rgb), max(c.rgb, d.rgb)), (a.a + b.a + c.a + d.a) / 4);
            }
            ENDHLSL
        }

        Pass // 2: what was blurred, outside of the objects; _MainTex is the blurred picture
        {
            Name "Composite"
            Tags { "LimnFullScreen" = "0 0 0 0 where _MainTex is 0 within 0 texels" }

            ZTest Always
            Cull Off
            ZWrite Off
            Blend SrcAlpha OneMinusSrcAlpha // the article's lerp, without a copy of the picture
            ColorMask RGB

            HLSLPROGRAM
            #pragma vertex BlitVertex
            #pragma fragment CompositeFragment

            TEXTURE2D(_StencilTex);
            float _OutlineStrength;

            half4 CompositeFragment(BlitVaryings input) : SV_Target
            {
                // The pixel's own: a blend with a neighbour, by as little as a place's rounding
                // makes of it, would take a pixel beside an object for one of it.
                half4 stencil = SAMPLE_TEXTURE2D(_StencilTex, sampler_PointClamp, input.uv);
                half4 blur = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, input.uv);
                bool isInside = any(stencil.rgb);
                return half4(blur.rgb * _OutlineStrength, isInside ? 0 : saturate(blur.a - stencil.a));
            }
            ENDHLSL
        }
    }
}

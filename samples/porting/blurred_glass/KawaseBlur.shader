// One step of Kawase's blur: four places around the pixel, each between texels.
Shader "Porting/KawaseBlur"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        float _Offset; // texels beyond the first border

        half4 FourAround(TEXTURE2D_PARAM(source, smp), float2 uv, float2 texel)
        {
            float2 reach = (_Offset + 0.5) * texel;
            half4 sum = SAMPLE_TEXTURE2D(source, smp, uv + reach);
            sum += SAMPLE_TEXTURE2D(source, smp, uv - reach);
            sum += SAMPLE_TEXTURE2D(source, smp, uv + float2(reach.x, -reach.y));
            sum += SAMPLE_TEXTURE2D(source, smp, uv + float2(-reach.x, reach.y));
            return sum * 0.25;
        }
        ENDHLSL

        Pass // for cmd.Blit
        {
            Name "Kawase"

            HLSLPROGRAM
            #pragma vertex QuadVertex
            #pragma fragment KawaseFragment

            TEXTURE2D(_MainTex);
            SAMPLER(sampler_LinearClamp);
            float4 _MainTex_TexelSize;

            struct Attributes
            {
                float4 positionOS : POSITION;
                float2 uv : TEXCOORD0;
            };

            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float2 uv : TEXCOORD0;
            };

            Varyings QuadVertex(Attributes input)
            {
                Varyings output;
                output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
                output.uv = input.uv;
                return output;
            }

            half4 KawaseFragment(Varyings input) : SV_Target
            {
                return FourAround(TEXTURE2D_ARGS(_MainTex, sampler_LinearClamp), input.uv, _MainTex_TexelSize.xy);
            }
            ENDHLSL
        }

        Pass // for Blitter
        {
            Name "KawaseBlitter"

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment KawaseFragment

            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 KawaseFragment(Varyings input) : SV_Target
            {
                return FourAround(TEXTURE2D_ARGS(_BlitTexture, sampler_LinearClamp), input.texcoord, _BlitTexture_TexelSize.xy);
            }
            ENDHLSL
        }
    }
}

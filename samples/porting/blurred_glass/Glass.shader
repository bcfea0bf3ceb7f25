// Shows what BlurredGlassFeature made of the picture behind it.
Shader "Porting/Glass"
{
    Properties
    {
        _Tint ("Tint", Color) = (0.8, 0.95, 1, 1)
        _Edge ("Brightness at grazing angles", Range(0, 1)) = 0.35
    }
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" "Queue" = "Transparent" }

        Pass
        {
            Name "Glass"
            Tags { "LightMode" = "UniversalForward" }

            HLSLPROGRAM
            #pragma vertex GlassVertex
            #pragma fragment GlassFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

            TEXTURE2D(_GlassBlurTexture);
            SAMPLER(sampler_LinearClamp);

            CBUFFER_START(UnityPerMaterial)
                half4 _Tint;
                half _Edge;
            CBUFFER_END

            struct Attributes
            {
                float4 positionOS : POSITION;
                float3 normalOS : NORMAL;
            };

            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float3 normalWS : TEXCOORD0;
                float3 viewWS : TEXCOORD1;
            };

            Varyings GlassVertex(Attributes input)
            {
                Varyings output;
                float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
                output.positionCS = TransformWorldToHClip(positionWS);
                output.normalWS = TransformObjectToWorldNormal(input.normalOS);
                output.viewWS = GetWorldSpaceViewDir(positionWS);
                return output;
            }

            half4 GlassFragment(Varyings input) : SV_Target
            {
                float2 uv = GetNormalizedScreenSpaceUV(input.positionCS);
                half3 behind = SAMPLE_TEXTURE2D(_GlassBlurTexture, sampler_LinearClamp, uv).rgb;
                half facing = saturate(dot(normalize(input.normalWS), normalize(input.viewWS)));
                half rim = pow(1 - facing, 3) * _Edge;
                return half4(behind * _Tint.rgb + rim, 1);
            }
            ENDHLSL
        }
    }
}

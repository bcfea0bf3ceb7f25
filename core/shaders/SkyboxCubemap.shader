// A picture of all that is around.
Shader "Skybox/Cubemap"
{
    Properties
    {
        _Tint ("Tint", Color) = (0.5, 0.5, 0.5, 0.5)
        [Gamma] _Exposure ("Exposure", Range(0, 8)) = 1
        _Rotation ("Rotation in degrees", Range(0, 360)) = 0
        [NoScaleOffset] _Tex ("Cubemap", Cube) = "grey" {}
    }
    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }
        Cull Off
        ZWrite Off

        Pass
        {
            Name "Cubemap"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment SkyFragment
            #include "limn/Skybox.hlsl"

            TEXTURECUBE(_Tex);
            SAMPLER(sampler_Tex);

            CBUFFER_START(UnityPerMaterial)
            half4 _Tint;
            half _Exposure;
            float _Rotation;
            CBUFFER_END

            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float3 direction : TEXCOORD0;
            };

            Varyings SkyVertex(float3 positionOS : POSITION)
            {
                Varyings output;
                output.positionCS = TransformObjectToHClip(positionOS);
                output.direction = limn_TurnSky(positionOS, -_Rotation);
                return output;
            }

            half4 SkyFragment(Varyings input) : SV_Target
            {
                float3 texel = SAMPLE_TEXTURECUBE(_Tex, sampler_Tex, input.direction).rgb;
                return half4(limn_SkyColor(texel, _Tint.rgb, _Exposure), 1.0);
            }
            ENDHLSL
        }
    }
}

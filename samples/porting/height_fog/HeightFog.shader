// Fog that thins out upwards: its density is _FogDensity at _FogBaseHeight and falls by e every
// 1 / _FogFalloff metres. What is left of a ray's light is worked out in closed form.
Shader "Porting/HeightFog"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"

        float _FogDensity;    // per metre
        float _FogBaseHeight; // metres
        float _FogFalloff;    // per metre
        half4 _FogColor;

        half4 Fogged(half4 color, float4 positionCS)
        {
            float depth = LoadSceneDepth(uint2(positionCS.xy));
            float2 uv = GetNormalizedScreenSpaceUV(positionCS);
            float3 positionWS = ComputeWorldSpacePosition(uv, depth, UNITY_MATRIX_I_VP);
            float3 ray = positionWS - GetCameraPositionWS();

            // The mean of exp(-x) for x from 0 to `rise`, whose closed form is 0 / 0 at a level ray.
            float rise = ray.y * _FogFalloff;
            float mean = abs(rise) < 1e-3 ? 1.0 - 0.5 * rise : (1.0 - exp(-rise)) / rise;
            float atCamera = _FogDensity * exp(-(GetCameraPositionWS().y - _FogBaseHeight) * _FogFalloff);
            float left = exp(-min(atCamera * length(ray) * mean, 80.0));
            return half4(lerp(_FogColor.rgb, color.rgb, left), color.a);
        }
        ENDHLSL

        Pass // for cmd.Blit
        {
            Name "HeightFog"

            HLSLPROGRAM
            #pragma vertex QuadVertex
            #pragma fragment FogFragment

            TEXTURE2D(_MainTex);

            float4 QuadVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half4 FogFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                return Fogged(LOAD_TEXTURE2D(_MainTex, uint2(positionCS.xy)), positionCS);
            }
            ENDHLSL
        }

        Pass // for Blitter
        {
            Name "HeightFogBlitter"

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment FogFragment

            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 FogFragment(Varyings input) : SV_Target
            {
                return Fogged(LOAD_TEXTURE2D_X(_BlitTexture, uint2(input.positionCS.xy)), input.positionCS);
            }
            ENDHLSL
        }
    }
}

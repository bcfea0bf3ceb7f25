// A colour over the parts of a surface that are seen at a flat angle; RimOutlinePass draws it over
// the objects. Technique 2 of the introduction of the article on selection outlines.
Shader "Hidden/Limn/RimOutline"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Back // the back of an edge lies so near to its front that the offset would show it
        ZWrite Off
        ZTest LEqual
        Offset -1, -1 // the depths to compare with come from other programs
        Blend SrcAlpha OneMinusSrcAlpha, Zero One

        Pass
        {
            Name "Rim"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex RimVertex
            #pragma fragment RimFragment
            #pragma multi_compile_local_fragment _SOFT _THRESHOLD _PIXELS

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "limn/outline/Hull.hlsl"

            half4 _RimColor;
            float _RimWidth;  // pixels
            float _RimFalloff;    // power of sin(theta)
            float _RimCosine;     // of the threshold

            struct Attributes
            {
                float4 positionOS : POSITION;
                float3 normalOS : NORMAL;
            };

            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float3 normalWS : TEXCOORD0;
                float3 toCameraWS : TEXCOORD1;
            };

            Varyings RimVertex(Attributes input)
            {
                Varyings output;
                output.positionCS = TransformObjectToHClip(input.positionOS.xyz);
                output.normalWS = SafeNormalize(OutlineNormalToWorld(input.normalOS));
                output.toCameraWS = limn_ObjectToWorldSpaceViewDir(input.positionOS.xyz);
                return output;
            }

            half4 RimFragment(Varyings input) : SV_Target
            {
                // theta is the angle between normal and line of sight.
                float facing = dot(SafeNormalize(input.normalWS), SafeNormalize(input.toCameraWS));
                float square = min(facing * facing, 1.0);
            #if defined(_SOFT)
                float strength = square < 1.0 ? exp2(0.5 * _RimFalloff * log2(1.0 - square)) : 0.0;
            #elif defined(_THRESHOLD)
                float strength = abs(facing) < _RimCosine ? 1.0 : 0.0;
            #else
                // On a ball the sine grows evenly up to 1 at the silhouette: by its slope that is so
                // far away. 1 - sine, negative beyond, where the slope is taken from as well.
                float lack = facing * abs(facing) / (1.0 + sqrt(1.0 - square));
                float slope = length(float2(ddx(lack), ddy(lack)));
                float strength = saturate(_RimWidth - max(lack, 0.0) / max(slope, 1e-6) + 0.5);
            #endif
                return half4(_RimColor.rgb, _RimColor.a * strength);
            }
            ENDHLSL
        }
    }
}

// An object's hull, moved outwards along its normals, in one colour; InflatedOutlinePass draws the
// object over it. Technique 1 of the introduction of the article on selection outlines.
Shader "Hidden/Limn/InflatedOutline"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        // Both sides: a sheet has no back, and the object covers what lies within it.
        Cull Off
        ZWrite Off
        ZTest LEqual
        Blend SrcAlpha OneMinusSrcAlpha, Zero One

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        #include "limn/outline/Hull.hlsl"

        half4 _InflatedColor;
        float _InflatedWidth; // pixels, or metres in the second pass

        struct Attributes
        {
            float4 positionOS : POSITION;
            float3 normalOS : NORMAL;
            float3 outlineOS : TEXCOORD7;
        };

        half4 HullFragment() : SV_Target { return _InflatedColor; }
        ENDHLSL

        Pass // 0: so many pixels on the screen, along baked normals where there are some
        {
            Name "HullInPixels"

            HLSLPROGRAM
            #pragma vertex HullVertex
            #pragma fragment HullFragment

            float4 HullVertex(Attributes input) : SV_POSITION
            {
                return HullPosition(input.positionOS.xyz, input.normalOS, input.outlineOS, _InflatedWidth);
            }
            ENDHLSL
        }

        Pass // 1: the article's, so many metres along the normals of the mesh
        {
            Name "HullInMetres"

            HLSLPROGRAM
            #pragma vertex HullVertex
            #pragma fragment HullFragment

            float4 HullVertex(Attributes input) : SV_POSITION
            {
                float3 normalWS = SafeNormalize(OutlineNormalToWorld(input.normalOS));
                float3 positionWS = TransformObjectToWorld(input.positionOS.xyz);
                return TransformWorldToHClip(positionWS + normalWS * _InflatedWidth);
            }
            ENDHLSL
        }
    }
}

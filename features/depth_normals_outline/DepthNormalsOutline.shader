// Lines where depth or normals change, drawn over the objects themselves: each is drawn once more
// where it is seen, and the colour blended by how much of an edge there is. Both passes differ in
// what an edge is only.
Shader "Hidden/Limn/DepthNormalsOutline"
{
    HLSLINCLUDE
    #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
    #include "limn/outline/OutlineObject.hlsl"

    half4 _OutlineColor;
    float _OutlineThickness;

    float4 ObjectVertex(float4 positionOS : POSITION) : SV_POSITION
    {
        return TransformObjectToHClip(positionOS.xyz);
    }
    ENDHLSL

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZWrite Off
        ZTest LEqual
        Offset -1, -1 // the depths to compare with come from other programs
        Blend SrcAlpha OneMinusSrcAlpha, Zero One

        Pass // 0: the article's
        {
            Name "Article"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex ObjectVertex
            #pragma fragment ArticleFragment

            float _DepthSensitivity;
            float _NormalsSensitivity;

            half4 ArticleFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                float edge;
                OutlineObject_float(GetNormalizedScreenSpaceUV(positionCS), _OutlineThickness,
                                    _DepthSensitivity, _NormalsSensitivity, edge);
                return half4(_OutlineColor.rgb, _OutlineColor.a * edge);
            }
            ENDHLSL
        }

        Pass // 1: by what the edges are in the world
        {
            Name "Hardened"
            Tags { "LimnWithinMesh" = "True" }

            HLSLPROGRAM
            #pragma vertex ObjectVertex
            #pragma fragment HardenedFragment

            float _DepthThreshold;
            float _AngleThreshold;
            float _Softness;

            half4 HardenedFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                float edge;
                OutlineObjectHardened_float(GetNormalizedScreenSpaceUV(positionCS),
                                            _OutlineThickness, _DepthThreshold, _AngleThreshold,
                                            _Softness, edge);
                return half4(_OutlineColor.rgb, _OutlineColor.a * edge);
            }
            ENDHLSL
        }
    }
}

// Overrides the materials of what XRayFeature shows. What is tested is in the feature's state blocks.
Shader "Porting/XRay"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZWrite Off

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        half4 _XRayColor;

        float4 XRayVertex(float4 positionOS : POSITION) : SV_POSITION
        {
            return TransformObjectToHClip(positionOS.xyz);
        }

        half4 XRayFragment() : SV_Target
        {
            return _XRayColor;
        }
        ENDHLSL

        Pass
        {
            Name "Mark"
            ColorMask 0
            ZTest LEqual
            Offset -1, -1 // the depths to compare with come from other programs

            HLSLPROGRAM
            #pragma vertex XRayVertex
            #pragma fragment XRayFragment
            ENDHLSL
        }

        Pass
        {
            Name "Color"
            Blend SrcAlpha OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma vertex XRayVertex
            #pragma fragment XRayFragment
            ENDHLSL
        }
    }
}

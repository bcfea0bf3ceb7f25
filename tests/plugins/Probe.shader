Shader "Hidden/Probe"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }

        Pass
        {
            Name "Paint"
            ZTest Always
            ZWrite Off
            Cull Off

            HLSLPROGRAM
            #pragma vertex PaintVertex
            #pragma fragment PaintFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/FullScreen.hlsl"
            #include "inc/ProbeColor.hlsl"

            float4 PaintVertex(uint id : SV_VertexID) : SV_POSITION
            {
                return GetFullScreenTriangleVertexPosition(id);
            }

            half4 PaintFragment() : SV_Target
            {
                return ProbeColor();
            }
            ENDHLSL
        }
    }
}

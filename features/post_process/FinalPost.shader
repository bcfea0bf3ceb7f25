// What comes behind all passes of a picture: fast approximate antialiasing.
Shader "Hidden/Universal Render Pipeline/FinalPost"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        Pass
        {
            Name "FinalPost"
            Tags { "LimnFullScreen" = "True" }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment FinalFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.universal/Shaders/PostProcessing/Common.hlsl"

            float4 FinalFragment(Varyings input) : SV_Target
            {
                float2 uv = input.texcoord;
                float4 color = SAMPLE_TEXTURE2D_X_LOD(_BlitTexture, sampler_PointClamp, uv, 0);
                int2 pixel = int2(uv * _BlitTexture_TexelSize.zw);
                color.rgb = ApplyFXAA(color.rgb, uv, pixel, _BlitTexture_TexelSize.zwxy, _BlitTexture);
                return color;
            }
            ENDHLSL
        }
    }
}

Shader "Porting/DistanceOutline"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        ZWrite Off
        ZTest Always
        Cull Off

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
        ENDHLSL

        Pass // 1 where an object is, hidden or not
        {
            Name "Mask"

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment MaskFragment

            float4 MaskVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half4 MaskFragment() : SV_Target
            {
                return 1;
            }
            ENDHLSL
        }

        Pass // _BlitTexture: distances in texels
        {
            Name "Composite"
            Blend SrcAlpha OneMinusSrcAlpha

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CompositeFragment

            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 _OutlineColor;
            float _OutlineWidth; // texels

            half4 CompositeFragment(Varyings input) : SV_Target
            {
                float distance = LOAD_TEXTURE2D_X(_BlitTexture, uint2(input.positionCS.xy)).r;
                // The border of what is covered lies half a texel before its first texel's middle.
                float cover = distance > 0 ? saturate(_OutlineWidth + 1 - distance) : 0;
                return half4(_OutlineColor.rgb, _OutlineColor.a * cover);
            }
            ENDHLSL
        }
    }
}

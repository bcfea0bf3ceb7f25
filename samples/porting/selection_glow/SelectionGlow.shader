// The glow around SelectionGlowFeature's objects: a mask, blurred by a Gaussian in two directions, and
// laid over the picture where the stencil does not have the objects themselves.
Shader "Hidden/Porting/SelectionGlow"
{
    Properties
    {
        _StencilReference ("Stencil reference", Int) = 2
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }
        Cull Off
        ZTest Always
        ZWrite Off

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        float4 _GlowDirection; // texels, x and y
        float _GlowDeviation;  // texels
        half4 _GlowColor;

        float4 ObjectVertex(float4 positionOS : POSITION) : SV_POSITION
        {
            return TransformObjectToHClip(positionOS.xyz);
        }

        half4 White() : SV_Target
        {
            return 1;
        }

        float Blur(TEXTURE2D(source), float4 texelSize, float4 positionCS)
        {
            int reach = (int)ceil(2.5 * _GlowDeviation);
            float sum = 0;
            float weights = 0;
            for (int i = -reach; i <= reach; i++)
            {
                float weight = exp(-0.5 * i * i / (_GlowDeviation * _GlowDeviation));
                int2 texel = int2(positionCS.xy) + i * int2(_GlowDirection.xy);
                sum += weight * LOAD_TEXTURE2D(source, clamp(texel, 0, int2(texelSize.zw) - 1)).r;
                weights += weight;
            }
            return sum / weights;
        }

        half4 Glow(float mask)
        {
            return half4(_GlowColor.rgb, _GlowColor.a * saturate(2 * mask));
        }
        ENDHLSL

        Pass
        {
            Name "Mark"
            ColorMask 0
            Stencil { Ref [_StencilReference] Pass Replace }

            HLSLPROGRAM
            #pragma vertex ObjectVertex
            #pragma fragment White
            ENDHLSL
        }

        Pass
        {
            Name "Mask"

            HLSLPROGRAM
            #pragma vertex ObjectVertex
            #pragma fragment White
            ENDHLSL
        }

        Pass // for cmd.Blit
        {
            Name "Blur"

            HLSLPROGRAM
            #pragma vertex ObjectVertex
            #pragma fragment BlurFragment

            TEXTURE2D(_MainTex);
            float4 _MainTex_TexelSize;

            float BlurFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                return Blur(_MainTex, _MainTex_TexelSize, positionCS);
            }
            ENDHLSL
        }

        Pass // for cmd.Blit
        {
            Name "Composite"
            Blend SrcAlpha OneMinusSrcAlpha, Zero One
            Stencil { Ref [_StencilReference] Comp NotEqual }

            HLSLPROGRAM
            #pragma vertex ObjectVertex
            #pragma fragment CompositeFragment

            TEXTURE2D(_MainTex);

            half4 CompositeFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                return Glow(LOAD_TEXTURE2D(_MainTex, uint2(positionCS.xy)).r);
            }
            ENDHLSL
        }

        Pass // for Blitter
        {
            Name "BlurBlitter"

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment BlurFragment

            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            float BlurFragment(Varyings input) : SV_Target
            {
                return Blur(_BlitTexture, _BlitTexture_TexelSize, input.positionCS);
            }
            ENDHLSL
        }

        Pass // for Blitter
        {
            Name "CompositeBlitter"
            Blend SrcAlpha OneMinusSrcAlpha, Zero One
            Stencil { Ref [_StencilReference] Comp NotEqual }

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CompositeFragment

            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 CompositeFragment(Varyings input) : SV_Target
            {
                return Glow(LOAD_TEXTURE2D_X(_BlitTexture, uint2(input.positionCS.xy)).r);
            }
            ENDHLSL
        }
    }
}

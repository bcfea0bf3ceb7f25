// The outline of the filtered objects in three passes; OutlineDrawingRenderPass runs them in order.
// Structure, states and arithmetic follow nscTechArt's article, the text is limn's own.
Shader "Hidden/ScreenSpaceOutline"
{
    SubShader
    {
        Tags
        {
            "RenderType" = "Opaque"
            "RenderPipeline" = "UniversalPipeline"
        }

        Pass // 0: the objects as a white mask, whatever stands in front of them
        {
            Name "Renderer Drawing Pass"
            Tags { "LimnWithinMesh" = "True" }

            Blend Off
            ZWrite Off
            ZTest Always
            Cull Back

            HLSLPROGRAM
            #pragma vertex MaskVertex
            #pragma fragment MaskFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

            float4 MaskVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half MaskFragment() : SV_Target
            {
                return 1;
            }
            ENDHLSL
        }

        Pass // 1: the edges of the mask by a Roberts cross of the outline's width
        {
            Name "Outline Edge Detection Pass"
            Tags { "LimnFullScreen" = "0 0 0 1 where _BlitTexture or _OutlineWidth is 0 within _OutlineWidth texels" }

            Blend Off
            ZWrite Off
            ZTest LEqual
            Cull Back

            HLSLPROGRAM
            #pragma vertex EdgeVertex
            #pragma fragment EdgeFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            float4 _BlitTexture_TexelSize;
            half _OutlineWidth;

            struct EdgeVaryings
            {
                float4 positionCS : SV_POSITION;
                float2 corners[4] : TEXCOORD0; // upper left, upper right, lower left, lower right
            };

            EdgeVaryings EdgeVertex(Attributes input)
            {
                EdgeVaryings output;
                output.positionCS = GetFullScreenTriangleVertexPosition(input.vertexID);
                float2 center = GetFullScreenTriangleTexCoord(input.vertexID);

                // The width counts pixels of the camera, the mask has half as many. An odd width is
                // split into its lower and upper half so that the cross stays as wide as asked.
                float2 pixel = _BlitTexture_TexelSize.xy * 0.5;
                float lower = floor(_OutlineWidth * 0.5);
                float upper = ceil(_OutlineWidth * 0.5);
                output.corners[0] = center + pixel * float2(lower, upper) * float2(-1,  1);
                output.corners[1] = center + pixel * float2(upper, lower) * float2( 1,  1);
                output.corners[2] = center + pixel * float2(lower, upper) * float2(-1, -1);
                output.corners[3] = center + pixel * float2(upper, lower) * float2( 1, -1);
                return output;
            }

            half EdgeFragment(EdgeVaryings input) : SV_Target
            {
                half mask[4];
                for (int i = 0; i < 4; i++)
                {
                    mask[i] = SAMPLE_TEXTURE2D(_BlitTexture, sampler_LinearClamp, input.corners[i]).r;
                }
                half rising = mask[1] - mask[2];
                half falling = mask[0] - mask[3];
                return sqrt(rising * rising + falling * falling);
            }
            ENDHLSL
        }

        Pass // 2: the edges in the outline's colour, added to the camera's colour; alpha is kept
        {
            Name "Outline Composite Pass"
            Tags { "LimnFullScreen" = "0 0 0 1 where _BlitTexture or _OutlineColor is 0 within 0 texels" }

            Cull Off
            ZTest NotEqual
            ZWrite Off
            Blend One SrcAlpha, Zero One
            BlendOp Add, Add

            HLSLPROGRAM
            #pragma vertex Vert
            #pragma fragment CompositeFragment

            #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
            #include "Packages/com.unity.render-pipelines.core/Runtime/Utilities/Blit.hlsl"

            half4 _OutlineColor;

            half4 CompositeFragment(Varyings input) : SV_Target
            {
                half edge = SAMPLE_TEXTURE2D(_BlitTexture, sampler_LinearClamp, input.texcoord).r;
                return half4(edge * _OutlineColor.rgb, 1);
            }
            ENDHLSL
        }
    }
}

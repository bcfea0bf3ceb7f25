// Lines where the normals or the objects of two neighbouring texels differ.
Shader "Porting/InkLines"
{
    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" }

        HLSLINCLUDE
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        TEXTURE2D(_InkNormals);
        TEXTURE2D(_InkIds);
        float4 _InkSize; // width, height
        half4 _InkColor;
        float _InkCosine; // of the angle from which on there is a line

        float3 NormalAt(int2 texel)
        {
            return LOAD_TEXTURE2D(_InkNormals, texel).xyz * 2 - 1;
        }

        half4 Ink(float4 positionCS)
        {
            int2 texel = int2(positionCS.xy);
            int2 last = int2(_InkSize.xy) - 1;
            float id = LOAD_TEXTURE2D(_InkIds, texel).r;
            float3 normal = NormalAt(texel);
            bool isLine = false;
            for (int i = 0; i < 4; i++)
            {
                int2 step = int2(i - 1 - (i / 2), i % 2 == i / 2 ? 1 : -1); // to the four corners
                int2 beside = clamp(texel + step, 0, last);
                bool isOther = LOAD_TEXTURE2D(_InkIds, beside).r != id;
                isLine = isLine || isOther || (id > 0 && dot(normal, NormalAt(beside)) < _InkCosine);
            }
            clip(isLine ? 1 : -1);
            return _InkColor;
        }
        ENDHLSL

        Pass
        {
            Name "Surface"

            HLSLPROGRAM
            #pragma vertex SurfaceVertex
            #pragma fragment SurfaceFragment

            struct SurfaceVaryings
            {
                float4 positionCS : SV_POSITION;
                float3 normalWS : TEXCOORD0;
            };

            struct SurfaceTargets
            {
                float4 normal : SV_Target0;
                float id : SV_Target1;
            };

            SurfaceVaryings SurfaceVertex(float4 positionOS : POSITION, float3 normalOS : NORMAL)
            {
                SurfaceVaryings output;
                output.positionCS = TransformObjectToHClip(positionOS.xyz);
                output.normalWS = TransformObjectToWorldNormal(normalOS);
                return output;
            }

            SurfaceTargets SurfaceFragment(SurfaceVaryings input)
            {
                float3 place = float3(UNITY_MATRIX_M._m03, UNITY_MATRIX_M._m13, UNITY_MATRIX_M._m23);
                SurfaceTargets output;
                output.normal = float4(normalize(input.normalWS) * 0.5 + 0.5, 1);
                output.id = (1 + floor(250 * frac(dot(place, float3(0.37, 0.61, 0.83))))) / 255;
                return output;
            }
            ENDHLSL
        }

        Pass // for RenderingUtils.fullscreenMesh
        {
            Name "Ink"
            Cull Off
            ZTest Always
            ZWrite Off
            Blend SrcAlpha OneMinusSrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex MeshVertex
            #pragma fragment InkFragment

            float4 MeshVertex(float4 positionOS : POSITION) : SV_POSITION
            {
                return TransformObjectToHClip(positionOS.xyz);
            }

            half4 InkFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                return Ink(positionCS);
            }
            ENDHLSL
        }

        Pass // for CoreUtils.DrawFullScreen
        {
            Name "InkTriangle"
            Cull Off
            ZTest Always
            ZWrite Off
            Blend SrcAlpha OneMinusSrcAlpha, Zero One

            HLSLPROGRAM
            #pragma vertex TriangleVertex
            #pragma fragment InkFragment

            float4 TriangleVertex(uint vertexID : SV_VertexID) : SV_POSITION
            {
                return GetFullScreenTriangleVertexPosition(vertexID);
            }

            half4 InkFragment(float4 positionCS : SV_POSITION) : SV_Target
            {
                return Ink(positionCS);
            }
            ENDHLSL
        }
    }
}

// One flat picture of all that is around, or of the half in front.
Shader "Skybox/Panoramic"
{
    Properties
    {
        _Tint ("Tint", Color) = (0.5, 0.5, 0.5, 0.5)
        [Gamma] _Exposure ("Exposure", Range(0, 8)) = 1
        _Rotation ("Rotation in degrees", Range(0, 360)) = 0
        [NoScaleOffset] _MainTex ("Picture", 2D) = "grey" {}
        [KeywordEnum(6 Frames Layout, Latitude Longitude Layout)] _Mapping ("Mapping", Float) = 1
        [Enum(360 Degrees, 0, 180 Degrees, 1)] _ImageType ("Picture of", Float) = 0
        [Toggle] _MirrorOnBack ("Mirror it on the back", Float) = 0
        [Enum(None, 0, Side by Side, 1, Over Under, 2)] _Layout ("Pictures for two eyes", Float) = 0
    }
    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }
        Cull Off
        ZWrite Off

        Pass
        {
            Name "Panoramic"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment SkyFragment
            #pragma shader_feature_local_fragment __ _MAPPING_6_FRAMES_LAYOUT
            #include "limn/Skybox.hlsl"
            #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonTexture.hlsl"

            TEXTURE2D(_MainTex);
            SAMPLER(sampler_MainTex);

            CBUFFER_START(UnityPerMaterial)
            float4 _MainTex_TexelSize;
            half4 _Tint;
            half _Exposure;
            float _Rotation;
            float _ImageType;
            float _MirrorOnBack;
            float _Layout;
            CBUFFER_END

            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float3 direction : TEXCOORD0;
            };

            Varyings SkyVertex(float3 positionOS : POSITION)
            {
                Varyings output;
                output.positionCS = TransformObjectToHClip(positionOS);
                output.direction = limn_TurnSky(positionOS, -_Rotation);
                return output;
            }

            // In the square of a face: x to the right and y down, from 0 to 1, as seen from inside.
            float2 InFace(float face, float3 direction)
            {
                float3 size = abs(direction);
                float away = max(size.x, max(size.y, size.z));
                float2 right = face == CUBEMAPFACE_POSITIVE_X   ? float2(-direction.z, direction.y)
                               : face == CUBEMAPFACE_NEGATIVE_X ? float2(direction.z, direction.y)
                               : face == CUBEMAPFACE_POSITIVE_Y ? float2(direction.x, -direction.z)
                               : face == CUBEMAPFACE_NEGATIVE_Y ? float2(direction.x, direction.z)
                               : face == CUBEMAPFACE_POSITIVE_Z ? float2(direction.x, direction.y)
                                                                : float2(-direction.x, direction.y);
                return float2(0.5, 0.5) + float2(0.5, -0.5) * right / away;
            }

            // Crosses and strips, by the shape of the picture.
            float3 SixFrames(float3 direction)
            {
                static const float2 k_Wide[6] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
                static const float2 k_High[6] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}};
                float2 texels = _MainTex_TexelSize.zw;
                float shape = texels.x / texels.y;
                int face = (int)CubeMapFaceID(direction);
                float2 inFace = InFace(face, direction);
                float2 cell;
                float2 cells;
                if (shape > 3.0 || shape < 1.0 / 3.0)
                {
                    cells = shape > 1.0 ? float2(6, 1) : float2(1, 6);
                    cell = shape > 1.0 ? float2(face, 0) : float2(0, face);
                }
                else
                {
                    cells = shape > 1.0 ? float2(4, 3) : float2(3, 4);
                    cell = shape > 1.0 ? k_Wide[face] : k_High[face];
                    if (shape <= 1.0 && face == 5)
                    {
                        inFace = 1.0 - inFace;
                    }
                }
                // A face ends at its border: nothing of its neighbour in the picture shows.
                float2 halfTexel = 0.5 * cells / texels;
                float2 place = (cell + clamp(inFace, halfTexel, 1.0 - halfTexel)) / cells;
                return SAMPLE_TEXTURE2D_LOD(_MainTex, sampler_MainTex,
                                            float2(place.x, 1.0 - place.y), 0.0).rgb;
            }

            // Longitude and latitude; +x is in the middle of the picture and +z left of it.
            float3 Around(float3 direction)
            {
                float3 d = normalize(direction);
                float2 uv = float2(0.5 - atan2(d.z, d.x) * 0.5 * INV_PI, 1.0 - acos(d.y) * INV_PI);
                // The mip level must not follow the jump where longitudes begin again.
                float other = frac(uv.x + 0.5);
                float2 change = float2(ddx(uv.x), ddy(uv.x));
                float2 ofOther = float2(ddx(other), ddy(other));
                change = dot(ofOther, ofOther) < dot(change, change) ? ofOther : change;
                float width = _ImageType > 0.5 ? 2.0 : 1.0;
                if (width * uv.x > (_ImageType > 0.5 && _MirrorOnBack < 0.5 ? 1.0 : 2.0))
                {
                    return 0.0;
                }
                uv.x = frac(width * uv.x);
                float2 part = _Layout < 0.5   ? float2(1, 1)
                              : _Layout < 1.5 ? float2(0.5, 1)
                                              : float2(1, 0.5);
                float2 first = float2(0, _Layout > 1.5 ? 0.5 : 0); // the left eye's
                float2 dx = float2(change.x * width, ddx(uv.y)) * part;
                float2 dy = float2(change.y * width, ddy(uv.y)) * part;
                uv = first + uv * part;
                return SAMPLE_TEXTURE2D_GRAD(_MainTex, sampler_MainTex, uv, dx, dy).rgb;
            }

            half4 SkyFragment(Varyings input) : SV_Target
            {
            #ifdef _MAPPING_6_FRAMES_LAYOUT
                float3 texel = SixFrames(input.direction);
            #else
                float3 texel = Around(input.direction);
            #endif
                return half4(limn_SkyColor(texel, _Tint.rgb, _Exposure), 1.0);
            }
            ENDHLSL
        }
    }
}

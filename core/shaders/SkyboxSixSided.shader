// Six pictures of what is around, a pass for each: the renderer draws the side of the cube that has
// the pass's number. Each is upright as seen from inside; up's lower border meets front's upper one.
Shader "Skybox/6 Sided"
{
    Properties
    {
        _Tint ("Tint", Color) = (0.5, 0.5, 0.5, 0.5)
        [Gamma] _Exposure ("Exposure", Range(0, 8)) = 1
        _Rotation ("Rotation in degrees", Range(0, 360)) = 0
        [NoScaleOffset] _FrontTex ("Front [+Z]", 2D) = "grey" {}
        [NoScaleOffset] _BackTex ("Back [-Z]", 2D) = "grey" {}
        [NoScaleOffset] _LeftTex ("Left [+X]", 2D) = "grey" {}
        [NoScaleOffset] _RightTex ("Right [-X]", 2D) = "grey" {}
        [NoScaleOffset] _UpTex ("Up [+Y]", 2D) = "grey" {}
        [NoScaleOffset] _DownTex ("Down [-Y]", 2D) = "grey" {}
    }
    HLSLINCLUDE
    #include "limn/Skybox.hlsl"
    #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/GlobalSamplers.hlsl"

    CBUFFER_START(UnityPerMaterial)
    half4 _Tint;
    half _Exposure;
    float _Rotation;
    CBUFFER_END

    struct Varyings
    {
        float4 positionCS : SV_POSITION;
        float2 uv : TEXCOORD0;
    };

    Varyings SkyVertex(float3 positionOS : POSITION, float2 uv : TEXCOORD0)
    {
        Varyings output;
        output.positionCS = TransformObjectToHClip(limn_TurnSky(positionOS, _Rotation));
        output.uv = uv;
        return output;
    }

    // A side ends at its border, however its texture is to be repeated elsewhere.
    half4 Side(TEXTURE2D(picture), float2 uv)
    {
        float3 texel = SAMPLE_TEXTURE2D(picture, sampler_LinearClamp, uv).rgb;
        return half4(limn_SkyColor(texel, _Tint.rgb, _Exposure), 1.0);
    }
    ENDHLSL
    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }
        Cull Off
        ZWrite Off

        Pass
        {
            Name "Front"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment FrontFragment
            TEXTURE2D(_FrontTex);
            half4 FrontFragment(Varyings input) : SV_Target { return Side(_FrontTex, input.uv); }
            ENDHLSL
        }

        Pass
        {
            Name "Back"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment BackFragment
            TEXTURE2D(_BackTex);
            half4 BackFragment(Varyings input) : SV_Target { return Side(_BackTex, input.uv); }
            ENDHLSL
        }

        Pass
        {
            Name "Left"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment LeftFragment
            TEXTURE2D(_LeftTex);
            half4 LeftFragment(Varyings input) : SV_Target { return Side(_LeftTex, input.uv); }
            ENDHLSL
        }

        Pass
        {
            Name "Right"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment RightFragment
            TEXTURE2D(_RightTex);
            half4 RightFragment(Varyings input) : SV_Target { return Side(_RightTex, input.uv); }
            ENDHLSL
        }

        Pass
        {
            Name "Up"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment UpFragment
            TEXTURE2D(_UpTex);
            half4 UpFragment(Varyings input) : SV_Target { return Side(_UpTex, input.uv); }
            ENDHLSL
        }

        Pass
        {
            Name "Down"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment DownFragment
            TEXTURE2D(_DownTex);
            half4 DownFragment(Varyings input) : SV_Target { return Side(_DownTex, input.uv); }
            ENDHLSL
        }
    }
}

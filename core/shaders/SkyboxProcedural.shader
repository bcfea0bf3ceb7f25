// Air around a ball, lit by the main light: single scattering as in S. O'Neil, "Accurate Atmospheric
// Scattering", GPU Gems 2 (2005), with the numbers that Unity's shader of this name has, for each
// pixel. Written from the paper and a description: its pictures were not compared with Unity's.
Shader "Skybox/Procedural"
{
    Properties
    {
        [KeywordEnum(None, Simple, High Quality)] _SunDisk ("Sun", Int) = 2
        _SunSize ("Sun size", Range(0, 1)) = 0.04
        _SunSizeConvergence ("Sun size convergence", Range(1, 10)) = 5
        _AtmosphereThickness ("Atmosphere thickness", Range(0, 5)) = 1
        _SkyTint ("Sky tint", Color) = (0.5, 0.5, 0.5, 1)
        _GroundColor ("Ground", Color) = (0.369, 0.349, 0.341, 1)
        _Exposure ("Exposure", Range(0, 8)) = 1.3
    }
    SubShader
    {
        Tags { "Queue" = "Background" "RenderType" = "Background" "PreviewType" = "Skybox" }
        Cull Off
        ZWrite Off

        Pass
        {
            Name "Procedural"

            HLSLPROGRAM
            #pragma vertex SkyVertex
            #pragma fragment SkyFragment
            #pragma multi_compile_local _SUNDISK_NONE _SUNDISK_SIMPLE _SUNDISK_HIGH_QUALITY
            #include "limn/Skybox.hlsl"

            CBUFFER_START(UnityPerMaterial)
            half4 _SkyTint;
            half4 _GroundColor;
            half _SunSize;
            half _SunSizeConvergence;
            half _AtmosphereThickness;
            half _Exposure;
            CBUFFER_END

            // Lengths in radii of the ball.
            #define AIR_HEIGHT 0.025
            #define EYE_HEIGHT 0.0001
            #define SCALE_HEIGHT 0.25 // where air is 1/e as dense, as a part of AIR_HEIGHT
            #define STEPS 2
            #define MIE 0.001
            #define SUN_BRIGHTNESS 20.0
            #define MOST_DEPTH 50.0
            #define HORIZON 0.02 // over which sky becomes ground

            struct Varyings
            {
                float4 positionCS : SV_POSITION;
                float3 direction : TEXCOORD0;
            };

            Varyings SkyVertex(float3 positionOS : POSITION)
            {
                Varyings output;
                output.positionCS = TransformObjectToHClip(positionOS);
                output.direction = positionOS;
                return output;
            }

            // How strongly air scatters each colour sidewards, by the molecules.
            float3 Rayleigh()
            {
                float3 longest = float3(0.65, 0.57, 0.475) + 0.15; // micrometres, of no tint
            #ifdef UNITY_COLORSPACE_GAMMA
                float3 tint = _SkyTint.rgb;
            #else
                float3 tint = LinearToSRGB(_SkyTint.rgb);
            #endif
                float3 wavelength = longest - 0.3 * tint;
                return 0.0025 * pow(abs(_AtmosphereThickness), 2.5) / Sq(Sq(wavelength));
            }
            float Density(float height) { return exp(-height / (AIR_HEIGHT * SCALE_HEIGHT)); }
            // Of all air from the ground out to space, at this cosine to the vertical.
            float Depth(float cosine)
            {
                float x = 1.0 - cosine;
                float bend = 0.459 + x * (3.83 + x * (-6.8 + x * 5.25));
                return SCALE_HEIGHT * exp(-0.00287 + x * bend);
            }
            float3 Attenuation(float depth, float3 rayleigh)
            {
                return exp(-clamp(depth, 0.0, MOST_DEPTH) * (rayleigh + MIE) * (4.0 * PI));
            }

            // What reaches the eye of light that is scattered on the way, for scattering of strength 1.
            float3 LightOfAir(float3 ray, float3 toSun, float3 rayleigh)
            {
                const float outer = 1.0 + AIR_HEIGHT;
                float way = sqrt(Sq(outer) + Sq(ray.y) - 1.0) - ray.y;
                float step = way / STEPS;
                float depthAtEye = Density(EYE_HEIGHT) * Depth(ray.y);
                float3 sum = 0.0;
                for (int i = 0; i < STEPS; ++i)
                {
                    float3 place = float3(0.0, 1.0 + EYE_HEIGHT, 0.0) + ray * (step * (i + 0.5));
                    float radius = length(place);
                    float density = Density(radius - 1.0);
                    float bend = Depth(dot(toSun, place) / radius) - Depth(dot(ray, place) / radius);
                    sum += Attenuation(depthAtEye + density * bend, rayleigh) * density;
                }
                return sum * (step / AIR_HEIGHT);
            }

            float3 Ground(float3 ray, float3 toSun, float3 rayleigh)
            {
                float way = EYE_HEIGHT / max(0.001, -ray.y);
                float3 eye = float3(0.0, 1.0 + EYE_HEIGHT, 0.0);
                float3 place = eye + ray * way;
                float depthToEye = Depth(dot(-ray, place));
                float depthToBoth = Depth(dot(toSun, place)) + depthToEye;
                float step = way / STEPS;
                float density = Density(length(eye + ray * (0.5 * step)) - 1.0);
                float beyondEye = exp(-EYE_HEIGHT / SCALE_HEIGHT) * depthToEye;
                float3 left = Attenuation(density * depthToBoth - beyondEye, rayleigh);
                float3 air = left * (density * step / AIR_HEIGHT);
                float3 color = _GroundColor.rgb;
            #ifdef UNITY_COLORSPACE_GAMMA
                color *= color;
            #endif
                return air * (rayleigh + MIE) * SUN_BRIGHTNESS + color * saturate(left);
            }

            // How bright the sun's disc is there, as a part of its brightest.
            float SunDisc(float3 ray, float3 toSun)
            {
            #if defined(_SUNDISK_SIMPLE)
                return 27.0 * Sq(1.0 - smoothstep(0.0, _SunSize, length(toSun - ray)));
            #elif defined(_SUNDISK_HIGH_QUALITY)
                const float g = 0.99; // light that drops scatter goes on nearly straight
                float cosine = pow(saturate(dot(toSun, ray)), _SunSizeConvergence);
                float spread = Sq(1.0 - g) + 2.0 * g * (1.0 - cosine);
                float narrowed = pow(abs(spread), 10.0 * pow(abs(_SunSize), 0.65));
                float scale = 1.5 * (1.0 - Sq(g)) / (2.0 + Sq(g));
                return 15.0 * scale * (1.0 + Sq(cosine)) / max(narrowed, 0.0001);
            #else
                return 0.0;
            #endif
            }

            half4 SkyFragment(Varyings input) : SV_Target
            {
                float3 ray = normalize(input.direction);
                float3 toSun = _MainLightPosition.xyz;
                float3 rayleigh = Rayleigh();
                float3 color = 0.0;
                if (ray.y >= 0.0)
                {
                    float3 air = LightOfAir(ray, toSun, rayleigh) * SUN_BRIGHTNESS;
                    float3 light = _MainLightColor.rgb;
                    float3 sun = saturate(air * MIE) * light / clamp(length(light), 0.25, 1.0);
                    color = air * rayleigh * (0.75 + 0.75 * Sq(dot(toSun, ray))) +
                            sun * SunDisc(ray, toSun);
                }
                else
                {
                    float3 onHorizon = SafeNormalize(float3(ray.x, 0.0, ray.z));
                    float3 air = LightOfAir(onHorizon, toSun, rayleigh) * SUN_BRIGHTNESS;
                    float3 sky = air * rayleigh * (0.75 + 0.75 * Sq(dot(toSun, ray)));
                    color = lerp(sky, Ground(ray, toSun, rayleigh), saturate(-ray.y / HORIZON));
                }
                color *= _Exposure;
            #ifdef UNITY_COLORSPACE_GAMMA
                color = sqrt(color); // it is worked out in linear light
            #endif
                return half4(color, 1.0);
            }
            ENDHLSL
        }
    }
}

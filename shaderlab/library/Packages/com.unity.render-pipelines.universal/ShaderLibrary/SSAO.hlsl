// Ambient occlusion from the depth texture (McGuire 2011, the Alchemy estimator), and the blurs behind
// it. A pass includes core's Blit.hlsl before; its script sets the parameters.
#pragma once
#ifndef UNIVERSAL_SSAO_INCLUDED
#define UNIVERSAL_SSAO_INCLUDED

#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/ShaderVariablesFunctions.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareNormalsTexture.hlsl"

TEXTURE2D(_BlueNoiseTexture);
TEXTURE2D_X(_ScreenSpaceOcclusionTexture);
SAMPLER(sampler_BlitTexture);

half4 _BlurOffset;
half _KawaseBlurIteration;
int _LastKawasePass;
half4 _SSAOParams; // intensity, radius, 1 or 0.5 where it has half the size, largest distance
float4 _SourceSize; // of the texture that is read: size, size of a texel
float4 _ProjectionParams2; // x: 1 / near
// From the camera to the upper left corner of the near plane, and along its edges
float4 _CameraViewTopLeftCorner[2];
float4 _CameraViewXExtent[2];
float4 _CameraViewYExtent[2];
float4 _CameraViewZExtent[2];
float4x4 _CameraViewProjections[2]; // without the camera's place
half4 _SSAOBlueNoiseParams; // scale, offset

#define INTENSITY _SSAOParams.x
#define RADIUS _SSAOParams.y
#define DOWNSAMPLE _SSAOParams.z
#define FALLOFF _SSAOParams.w
#define BlueNoiseScale _SSAOBlueNoiseParams.xy
#define BlueNoiseOffset _SSAOBlueNoiseParams.zw
#define SCREEN_PARAMS GetScaledScreenParams()
#define unity_eyeIndex 0
#define SAMPLE_BASEMAP(uv) half4(SAMPLE_TEXTURE2D_X(_BlitTexture, sampler_BlitTexture, uv));
#define SAMPLE_BASEMAP_R(uv) half(SAMPLE_TEXTURE2D_X(_BlitTexture, sampler_BlitTexture, uv).r);
#define SAMPLE_BLUE_NOISE(uv) SAMPLE_TEXTURE2D(_BlueNoiseTexture, sampler_PointRepeat, uv).a;

#if defined(LIMN_SSAO_SAMPLES) // any number, for who compares
static const int SAMPLE_COUNT = LIMN_SSAO_SAMPLES;
#elif defined(_SAMPLE_COUNT_HIGH)
static const int SAMPLE_COUNT = 12;
#elif defined(_SAMPLE_COUNT_MEDIUM)
static const int SAMPLE_COUNT = 8;
#else
static const int SAMPLE_COUNT = 4;
#endif
// Of u = 0, then of u = 1
static const half SSAORandomUV[40] = {
    0.00000000, 0.33984375, 0.75390625, 0.56640625, 0.98437500, 0.07421875, 0.23828125, 0.64062500,
    0.35937500, 0.50781250, 0.38281250, 0.98437500, 0.17578125, 0.53906250, 0.28515625, 0.23137260,
    0.45882360, 0.54117650, 0.12941180, 0.64313730, 0.92968750, 0.76171875, 0.13333330, 0.01562500,
    0.00000000, 0.10546875, 0.64062500, 0.74609375, 0.67968750, 0.35156250, 0.49218750, 0.12500000,
    0.26562500, 0.62500000, 0.44531250, 0.17647060, 0.44705890, 0.93333340, 0.87058830, 0.56862750};

static const half kContrast = 0.6;
static const half kGeometryCoeff = 0.8; // normals with less than this for a cosine do not mix
static const half kBeta = 0.004;        // what a surface hides of itself
static const half kEpsilon = 0.0001;

half4 PackAONormal(half ao, half3 n) { return half4(ao, n * 0.5 + 0.5); }
half3 GetPackedNormal(half4 p) { return p.gba * 2.0 - 1.0; }
half GetPackedAO(half4 p) { return p.r; }
half EncodeAO(half x) { return x; }
half CompareNormal(half3 d1, half3 d2) { return smoothstep(kGeometryCoeff, 1.0, dot(d1, d2)); }
float2 GetScreenSpacePosition(float2 uv) { return uv * SCREEN_PARAMS.xy * DOWNSAMPLE; }
half GetRandomVal(half u, half sampleIndex)
{
#ifdef LIMN_SSAO_SAMPLES
    return frac((sampleIndex + 0.5) * (u > 0.0 ? 0.56984029 : 0.75487767)); // Roberts 2018, R2
#else
    return SSAORandomUV[(int)(u * 20 + sampleIndex)];
#endif
}

// A place within the radius, on the normal's side.
half3 PickSamplePoint(float2 uv, int sampleIndex, half sampleIndexHalf, half rcpSampleCount,
                      half3 normal_o, float2 pixelDensity)
{
    half first = GetRandomVal(0, sampleIndexHalf);
    half second = GetRandomVal(1, sampleIndexHalf);
#ifdef _BLUE_NOISE
    half share = sampleIndexHalf * rcpSampleCount;
    half noise = SAMPLE_BLUE_NOISE((uv + BlueNoiseOffset) * BlueNoiseScale + share);
    half turns = (second + noise) * 100.0;
    half size = lerp(0.1, 1.0, share * share);
#else
    half noise = InterleavedGradientNoise(GetScreenSpacePosition(uv), sampleIndex);
    half turns = second + noise;
    half size = sqrt((sampleIndexHalf + 1.0) * rcpSampleCount);
#endif
    half height = frac(first + noise) * 2.0 - 1.0;
    half angle = turns * TWO_PI;
    half3 v = half3(sqrt(1.0 - height * height) * half2(cos(angle), sin(angle)), height);
    v *= dot(normal_o, v) >= 0.0 ? size : -size;
    return v * RADIUS * half3(pixelDensity, 1.0);
}

// Depth is taken where the texture has it, in the middle of a texel: a surface's depth beside its
// place would make hills and hollows of a plane.
float2 limn_SsaoTexel(float2 uv)
{
    float2 size = _CameraDepthTexture_TexelSize.zw;
    return clamp(floor(uv * size), 0.0, size - 1.0);
}
float2 limn_SsaoMiddle(float2 uv)
{
    return (limn_SsaoTexel(uv) + 0.5) * _CameraDepthTexture_TexelSize.xy;
}
// A pixel of a picture of half the size lies where four texels meet: clearly in one of them.
#define ADJUSTED_DEPTH_UV(uv) limn_SsaoMiddle((uv).xy + 0.25 * _CameraDepthTexture_TexelSize.xy)
float SampleDepth(float2 uv) { return LoadSceneDepth(uint2(limn_SsaoTexel(uv))); }
bool limn_SsaoIsSky(float rawDepth)
{
#if defined(UNITY_REVERSED_Z)
    return rawDepth <= 0.0;
#else
    return rawDepth >= 1.0;
#endif
}
float GetLinearEyeDepth(float rawDepth)
{
#ifdef _ORTHOGRAPHIC
    return LinearDepthToEyeDepth(rawDepth);
#else
    return LinearEyeDepth(rawDepth, _ZBufferParams);
#endif
}
float SampleAndGetLinearEyeDepth(float2 uv) { return GetLinearEyeDepth(SampleDepth(uv)); }

// From the camera, along the axes of the world.
half3 ReconstructViewPos(float2 uv, float linearDepth)
{
    float3 near = _CameraViewTopLeftCorner[0].xyz + _CameraViewXExtent[0].xyz * uv.x +
                  _CameraViewYExtent[0].xyz * (1.0 - uv.y);
#ifdef _ORTHOGRAPHIC
    return near + _CameraViewZExtent[0].xyz * (linearDepth * _ProjectionParams.w);
#else
    return near * (linearDepth * _ProjectionParams2.x);
#endif
}

// Along the surface to the next texel on one axis. Which of the two: LOW the one ahead, if that
// is no sky; MEDIUM the one whose depth is more alike; else the one on whose side two texels foretell
// this one's depth, which is affine on planes.
float3 limn_SsaoStep(float2 uv, float2 apart, float linearDepth, float3 place)
{
    float2 back = uv - apart;
    float2 ahead = uv + apart;
#if defined(_SOURCE_DEPTH_LOW)
    bool isBack = limn_SsaoIsSky(SampleDepth(ahead));
#elif defined(_SOURCE_DEPTH_MEDIUM)
    bool isBack = abs(SampleAndGetLinearEyeDepth(back) - linearDepth) <
                  abs(SampleAndGetLinearEyeDepth(ahead) - linearDepth);
#else
    float raw = SampleDepth(uv);
    bool isBack = abs(2.0 * SampleDepth(back) - SampleDepth(back - apart) - raw) <
                  abs(2.0 * SampleDepth(ahead) - SampleDepth(ahead + apart) - raw);
#endif
    isBack = any(ahead > 1.0) || (isBack && all(back > 0.0)); // the picture ends there
    float2 next = isBack ? back : ahead;
    float3 way = ReconstructViewPos(next, SampleAndGetLinearEyeDepth(next)) - place;
    return isBack ? -way : way;
}
half3 ReconstructNormal(float2 uv, float linearDepth, float3 vpos, float2 pixelDensity)
{
    float2 apart = _CameraDepthTexture_TexelSize.xy / pixelDensity;
    return SafeNormalize(cross(limn_SsaoStep(uv, float2(0.0, apart.y), linearDepth, vpos),
                               limn_SsaoStep(uv, float2(apart.x, 0.0), linearDepth, vpos)));
}
half3 SampleNormal(float2 uv, float linearDepth, float2 pixelDensity)
{
#ifdef _SOURCE_DEPTH_NORMALS
    return LoadSceneNormals(uint2(limn_SsaoTexel(uv)));
#else
    return ReconstructNormal(uv, linearDepth, ReconstructViewPos(uv, linearDepth), pixelDensity);
#endif
}

// How much a sampled place hides of a pixel at `place`.
half limn_SsaoHidden(half3 place, half3 normal, half depth, half3 offset)
{
    half distance = depth - dot(UNITY_MATRIX_V[2].xyz, offset); // a view looks along -z
    half2 clip = mul(_CameraViewProjections[0], half4(place + offset, 1.0)).xy;
#ifndef _ORTHOGRAPHIC
    if (distance <= 0.0)
    {
        return 0.0; // behind the camera
    }
    clip /= distance;
#endif
    float2 uv = limn_SsaoMiddle(clip * 0.5 + 0.5);
    float raw = SampleDepth(uv);
    float there = GetLinearEyeDepth(raw);
    bool counts = abs(distance - there) < RADIUS && !limn_SsaoIsSky(raw);
    half3 way = ReconstructViewPos(uv, there) - place;
    half height = max(dot(way, normal) - kBeta * depth, 0.0);
    return counts ? height / (dot(way, way) + kEpsilon) : 0.0;
}

half4 SSAO(Varyings input) : SV_Target
{
    float2 uv = ADJUSTED_DEPTH_UV(input.texcoord);
    float raw = SampleDepth(uv);
    half depth = GetLinearEyeDepth(raw);
    if (limn_SsaoIsSky(raw) || depth > FALLOFF)
    {
        return PackAONormal(0, half3(0, 0, 0));
    }
    float2 density = float2(1, 1);
    half3 normal = SampleNormal(uv, depth, density);
    half3 place = ReconstructViewPos(uv, depth);
    half sum = 0;
#ifndef LIMN_SSAO_SAMPLES
    UNITY_UNROLL // the table's numbers are constants then
#endif
    for (int s = 0; s < SAMPLE_COUNT; ++s)
    {
        half3 offset = PickSamplePoint(input.texcoord, s, s, 1.0 / SAMPLE_COUNT, normal, density);
        sum += limn_SsaoHidden(place, normal, depth, offset);
    }
    half near = 1.0 - depth / FALLOFF;
    half ao = saturate(sum * RADIUS * INTENSITY * near * near / SAMPLE_COUNT);
    return PackAONormal(PositivePow(ao, kContrast), normal);
}

// A pixel and others, weighed by how alike their normals are.
half4 limn_SsaoMixed(half4 all, float2 uv, half3 normal, half weight)
{
    half4 p = SAMPLE_BASEMAP(uv);
    weight *= CompareNormal(normal, GetPackedNormal(p));
    return all + half4(GetPackedAO(p) * weight, weight, 0, 0);
}
half4 Blur(const float2 uv, const float2 delta) : SV_Target
{
    half4 centre = SAMPLE_BASEMAP(uv);
    half3 normal = GetPackedNormal(centre);
    half4 all = half4(GetPackedAO(centre), 1, 0, 0) * 0.2270270270;
    all = limn_SsaoMixed(all, uv - delta * 1.3846153846, normal, 0.3162162162);
    all = limn_SsaoMixed(all, uv + delta * 1.3846153846, normal, 0.3162162162);
    all = limn_SsaoMixed(all, uv - delta * 3.2307692308, normal, 0.0702702703);
    all = limn_SsaoMixed(all, uv + delta * 3.2307692308, normal, 0.0702702703);
    return PackAONormal(all.x / all.y, normal);
}
half BlurSmall(const float2 uv, const float2 delta)
{
    half4 centre = SAMPLE_BASEMAP(uv);
    half3 normal = GetPackedNormal(centre);
    half4 all = half4(GetPackedAO(centre), 1, 0, 0);
    all = limn_SsaoMixed(all, uv - delta, normal, 1);
    all = limn_SsaoMixed(all, uv + delta * float2(1, -1), normal, 1);
    all = limn_SsaoMixed(all, uv + delta * float2(-1, 1), normal, 1);
    all = limn_SsaoMixed(all, uv + delta, normal, 1);
    return all.x / all.y;
}
#define limn_SSAO_TEXEL (_SourceSize.zw * rcp(DOWNSAMPLE))
half4 HorizontalBlur(Varyings input) : SV_Target
{
    return Blur(input.texcoord, float2(limn_SSAO_TEXEL.x, 0));
}
half4 VerticalBlur(Varyings input) : SV_Target
{
    return Blur(input.texcoord, float2(0, limn_SSAO_TEXEL.y));
}
half4 FinalBlur(Varyings input) : SV_Target
{
    return 1.0 - BlurSmall(input.texcoord, limn_SSAO_TEXEL);
}

// Seven texels by four fetches between them.
half limn_SsaoPair(half2 uv, half2 apart)
{
    half4 a = SAMPLE_BASEMAP(uv + apart);
    half4 b = SAMPLE_BASEMAP(uv - apart);
    return a.r + b.r;
}
half GaussianBlur(half2 uv, half2 pixelOffset)
{
    return limn_SsaoPair(uv, pixelOffset * 0.53805) * 0.44908 +
           limn_SsaoPair(uv, pixelOffset * 2.06278) * 0.05092;
}
half HorizontalGaussianBlur(Varyings input) : SV_Target
{
    return GaussianBlur(input.texcoord, half2(limn_SSAO_TEXEL.x, 0));
}
half VerticalGaussianBlur(Varyings input) : SV_Target
{
    return 1.0 - GaussianBlur(input.texcoord, half2(0, limn_SSAO_TEXEL.y));
}

// Four fetches at corners that lie farther out with each pass (Kawase 2003).
half KawaseBlurFilter(half2 texCoord, half2 pixelSize, half iteration)
{
    half2 corner = pixelSize * (iteration + 0.5);
    return (limn_SsaoPair(texCoord, corner) +
            limn_SsaoPair(texCoord, corner * half2(1, -1))) * 0.25;
}
half KawaseBlur(Varyings input) : SV_Target
{
    half blurred = KawaseBlurFilter(input.texcoord, limn_SSAO_TEXEL, _KawaseBlurIteration);
    return _LastKawasePass ? 1.0 - blurred : blurred;
}
#endif

// Functions for the nodes of shader graphs that take more than one expression. The names and results
// are those of Shader Graph's manual, "Node Library".
#pragma once
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Hashes.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Packing.hlsl"

#define limn_FOR_VECTORS(Make) Make(float) Make(float2) Make(float3) Make(float4)

// All four numbers of a vector; those that it lacks are 0.
float4 limn_Wide(float v) { return float4(v, 0, 0, 0); }
float4 limn_Wide(float2 v) { return float4(v, 0, 0); }
float4 limn_Wide(float3 v) { return float4(v, 0); }
float4 limn_Wide(float4 v) { return v; }
// The first of four numbers, as many as another vector has.
float limn_Narrow(float4 v, float as) { return v.x; }
float2 limn_Narrow(float4 v, float2 as) { return v.xy; }
float3 limn_Narrow(float4 v, float3 as) { return v.xyz; }
float4 limn_Narrow(float4 v, float4 as) { return v; }

// mask: a bit a channel
#define limn_MASKED(Vector) \
    Vector limn_Masked(Vector v, int mask) \
    { \
        float4 kept = float4(mask & 1, (mask >> 1) & 1, (mask >> 2) & 1, (mask >> 3) & 1); \
        return v * limn_Narrow(kept, v); \
    }
limn_FOR_VECTORS(limn_MASKED)

// A colour that a graph has as people see it.
float3 limn_GraphColor(float3 color)
{
#ifdef UNITY_COLORSPACE_GAMMA
    return color;
#else
    return SRGBToLinear(color);
#endif
}

// ---- The object and the scene

float3 limn_ObjectScale()
{
    return float3(length(UNITY_MATRIX_M._m00_m10_m20), length(UNITY_MATRIX_M._m01_m11_m21),
                  length(UNITY_MATRIX_M._m02_m12_m22));
}
float limn_EyeDepthOf(float3 positionWS) { return -TransformWorldToView(positionWS).z; }
float limn_SceneEyeDepth(float2 uv)
{
    float depth = SHADERGRAPH_SAMPLE_SCENE_DEPTH(uv);
    return unity_OrthoParams.w > 0.5
        ? limn_EyeDepthOf(ComputeWorldSpacePosition(uv, depth, UNITY_MATRIX_I_VP))
        : LinearEyeDepth(depth, _ZBufferParams);
}
// xy: where the screen shows a place, z: its depth
float3 limn_WorldToScreen(float3 positionWS)
{
    float4 positionCS = TransformWorldToHClip(positionWS);
    return float3(ComputeNormalizedDeviceCoordinates(positionWS, UNITY_MATRIX_VP),
                  positionCS.z / positionCS.w);
}
// The picture that a full-screen pass is given.
TEXTURE2D_X(_BlitTexture);
float4 limn_SampleBlitSource(float2 uv)
{
    return LOAD_TEXTURE2D_X_LOD(_BlitTexture, uint2(uv * _ScreenSize.xy), 0);
}
// a: the density
float4 limn_GraphFog(float3 positionOS)
{
    float4 color;
    float density;
    SHADERGRAPH_FOG(positionOS, color, density);
    return float4(color.rgb, density);
}

// ---- Mathematics

float limn_RandomOf(float2 seed)
{
    return frac(sin(dot(seed, float2(12.9898, 78.233))) * 43758.5453);
}
#define limn_NOISE_SINE_WAVE(Vector) \
    Vector limn_NoiseSineWave(Vector angle, float2 minMax) \
    { \
        Vector change = sin(angle) - sin(angle + 1.0); \
        Vector random = frac(sin(change * (12.9898 + 78.233)) * 43758.5453); \
        return sin(angle) + lerp(minMax.x, minMax.y, random); \
    }
limn_FOR_VECTORS(limn_NOISE_SINE_WAVE)

// Rodrigues' formula.
float3 limn_RotateAboutAxis(float3 v, float3 axis, float angle)
{
    axis = normalize(axis);
    float3 along = axis * dot(axis, v);
    return along + (v - along) * cos(angle) + cross(axis, v) * sin(angle);
}

// ---- Coordinates

float2 limn_Turned(float2 v, float angle)
{
    float s = sin(angle);
    float c = cos(angle);
    return float2(c * v.x - s * v.y, s * v.x + c * v.y);
}
float2 limn_RotateUV(float2 uv, float2 center, float angle)
{
    return limn_Turned(uv - center, -angle) + center;
}
float2 limn_Twirl(float2 uv, float2 center, float strength)
{
    float2 fromCenter = uv - center;
    return limn_Turned(fromCenter, strength * length(fromCenter)) + center;
}
float2 limn_PolarCoordinates(float2 fromCenter, float radialScale, float lengthScale)
{
    return float2(length(fromCenter) * 2.0 * radialScale,
                  atan2(fromCenter.x, fromCenter.y) * (1.0 / 6.28) * lengthScale);
}
// inverted: 1 where an axis counts backwards
float2 limn_Flipbook(float2 uv, float2 size, float tile, float2 inverted)
{
    tile = floor(fmod(tile + 0.00001, size.x * size.y));
    float row = floor((tile + 0.00001) / size.x);
    float2 cell = float2(tile - size.x * row, row);
    return (uv + lerp(cell, size - 1.0 - cell, inverted)) / size;
}
float2 limn_Parallax(float height, float amplitude, float3 viewTS, float2 uv)
{
    viewTS = normalize(viewTS);
    return uv + (height * amplitude - amplitude * 0.5) * viewTS.xy / (viewTS.z + 0.42);
}

// ---- Patterns

// Dave Hoskins' smooth value noise over a lattice, of the hash that Random gives.
#define limn_SIMPLE_NOISE(Name, Random) \
    float limn_Value##Name(float2 uv) \
    { \
        float2 cell = floor(uv); \
        float2 within = frac(uv); \
        within = within * within * (3.0 - 2.0 * within); \
        float lower = lerp(Random(cell), Random(cell + float2(1, 0)), within.x); \
        float upper = lerp(Random(cell + float2(0, 1)), Random(cell + 1), within.x); \
        return lerp(lower, upper, within.y); \
    } \
    float limn_##Name(float2 uv) \
    { \
        return limn_Value##Name(uv) * 0.125 + limn_Value##Name(uv / 2) * 0.25 + \
            limn_Value##Name(uv / 4) * 0.5; \
    }
float limn_HashOf(float2 cell)
{
    float hash;
    Hash_Tchou_2_1_float(cell, hash);
    return hash;
}
limn_SIMPLE_NOISE(SimpleNoise, limn_HashOf)
limn_SIMPLE_NOISE(LegacySimpleNoise, limn_RandomOf)

float2 limn_NoiseDirection(float hash)
{
    float x = hash * 2.0 - 1.0;
    return normalize(float2(x - floor(x + 0.5), abs(x) - 0.5));
}
float2 limn_GradientAt(float2 cell) { return limn_NoiseDirection(limn_HashOf(cell)); }
float2 limn_LegacyGradientAt(float2 cell)
{
    cell = fmod(cell, 289.0);
    float x = fmod((34.0 * cell.x + 1.0) * cell.x, 289.0) + cell.y;
    x = fmod((34.0 * x + 1.0) * x, 289.0);
    return limn_NoiseDirection(frac(x / 41.0));
}
// Perlin's noise around 0.5.
#define limn_GRADIENT_NOISE(Name, GradientAt) \
    float limn_##Name(float2 uv) \
    { \
        float2 cell = floor(uv); \
        float2 within = frac(uv); \
        float a = dot(GradientAt(cell), within); \
        float b = dot(GradientAt(cell + float2(0, 1)), within - float2(0, 1)); \
        float c = dot(GradientAt(cell + float2(1, 0)), within - float2(1, 0)); \
        float d = dot(GradientAt(cell + 1), within - 1); \
        within = within * within * within * (within * (within * 6 - 15) + 10); \
        return lerp(lerp(a, b, within.y), lerp(c, d, within.y), within.x) + 0.5; \
    }
limn_GRADIENT_NOISE(GradientNoise, limn_GradientAt)
limn_GRADIENT_NOISE(LegacyGradientNoise, limn_LegacyGradientAt)

float2 limn_VoronoiPoint(float2 cell)
{
    float2 hash;
    Hash_Tchou_2_2_float(cell, hash);
    return hash;
}
float2 limn_LegacyVoronoiPoint(float2 cell)
{
    return frac(sin(mul(cell, float2x2(15.27, 47.63, 99.41, 89.98))) * 46839.32);
}
// The distance to the nearest point, and a number of its cell.
#define limn_VORONOI(Name, PointOf) \
    float2 limn_##Name(float2 uv, float angleOffset) \
    { \
        float2 nearest = float2(8, 0); \
        for (int y = -1; y <= 1; ++y) \
            for (int x = -1; x <= 1; ++x) \
            { \
                float2 hash = PointOf(float2(x, y) + floor(uv)); \
                float2 place = float2(sin(hash.y * angleOffset), cos(hash.x * angleOffset)); \
                place = place * 0.5 + 0.5; \
                float d = distance(float2(x, y) + place, frac(uv)); \
                nearest = d < nearest.x ? float2(d, place.x) : nearest; \
            } \
        return nearest; \
    }
limn_VORONOI(Voronoi, limn_VoronoiPoint)
limn_VORONOI(LegacyVoronoi, limn_LegacyVoronoiPoint)

// 1 inside of a shape, whose border is where the distance is 1, a pixel soft. The distance does not
// change in the middle of some shapes: nothing is divided by 0 there.
float limn_ShapeOf(float distance)
{
    return saturate((1 - distance) / max(fwidth(distance), 1e-6));
}
float limn_PolygonDistance(float2 uv, float sides, float width, float height)
{
    float2 at = (uv * 2 - 1) / (float2(width, height) * cos(PI / sides));
    float angle = atan2(at.x, -at.y);
    float side = 2 * PI / sides;
    return cos(floor(0.5 + angle / side) * side - angle) * length(at);
}
// isNicest: the border is a pixel soft to either side at all sizes
float limn_Rectangle(float2 uv, float2 size, int isNicest)
{
    float2 outside = abs(uv * 2 - 1) - size;
    if (isNicest)
    {
        float2 width = fwidth(uv);
        float2 soft = saturate(0.5 - outside / max(width * 2, 1e-6));
        return soft.x * soft.y;
    }
    float2 inside = saturate(1 - outside / max(fwidth(outside), 1e-6));
    return min(inside.x, inside.y);
}
float limn_RoundedRectangle(float2 uv, float2 size, float radius)
{
    radius = max(min(min(abs(radius * 2), abs(size.x)), abs(size.y)), 1e-5);
    return limn_ShapeOf(length(max(0, abs(uv * 2 - 1) - size + radius)) / radius);
}
float3 limn_Checkerboard(float2 uv, float3 a, float3 b, float2 frequency)
{
    uv = (uv + 0.5) * frequency;
    float2 change = sqrt(ddx(uv) * ddx(uv) + ddy(uv) * ddy(uv));
    float2 wave = clamp((4.0 * abs(frac(uv + 0.25) - 0.5) - 1.0) * 0.35 / max(change, 1e-6), -1.0, 1.0);
    float blurred = sqrt(saturate(1.1 - max(change.x, change.y)));
    return lerp(a, b, saturate(0.5 + 0.5 * wave.x * wave.y * blurred));
}
// Bayer's matrix of four by four.
float limn_DitherThreshold(float2 uv)
{
    const float thresholds[16] = {1, 9, 3, 11, 13, 5, 15, 7, 4, 12, 2, 10, 16, 8, 14, 6};
    uint2 pixel = uint2(uv * _ScreenParams.xy) & 3u;
    return thresholds[pixel.x * 4 + pixel.y] / 17.0;
}
#define limn_DITHER(Vector) \
    Vector limn_Dither(Vector v, float2 uv) { return v - limn_DitherThreshold(uv); }
limn_FOR_VECTORS(limn_DITHER)

// ---- Colours

float limn_KeyPlace(float time, float before, float after, bool isFixed)
{
    float place = saturate((time - before) / max(after - before, 1e-6));
    return isFixed ? step(0.01, place) : place;
}
// type 1: the next key's colour; 2: blended evenly for the eye, in Oklab
float4 limn_SampleGradient(Gradient gradient, float time)
{
    bool isFixed = gradient.type == 1;
    bool isEven = gradient.type == 2;
    float3 color = isEven ? LinearToOklab(gradient.colors[0].rgb) : gradient.colors[0].rgb;
    float alpha = gradient.alphas[0].x;
    for (int c = 1; c < 8; ++c)
    {
        float place = limn_KeyPlace(time, gradient.colors[c - 1].w, gradient.colors[c].w, isFixed);
        float3 key = gradient.colors[c].rgb;
        color = lerp(color, isEven ? LinearToOklab(key) : key,
                     c < gradient.colorsLength ? place : 0.0);
    }
    color = isEven ? OklabToLinear(color) : color;
#ifdef UNITY_COLORSPACE_GAMMA
    color = LinearToSRGB(color);
#endif
    for (int a = 1; a < 8; ++a)
    {
        float place = limn_KeyPlace(time, gradient.alphas[a - 1].y, gradient.alphas[a].y, isFixed);
        alpha = lerp(alpha, gradient.alphas[a].x, a < gradient.alphasLength ? place : 0.0);
    }
    return float4(color, alpha);
}

// The modes of the node Blend by their numbers in its file; b is the base, s what blends with it.
#define limn_BLEND_MODES(Vector) \
    Vector limn_Blend0(Vector b, Vector s) { return 1.0 - (1.0 - s) / (b + 1e-12); } \
    Vector limn_Blend1(Vector b, Vector s) { return min(s, b); } \
    Vector limn_Blend2(Vector b, Vector s) { return abs(s - b); } \
    Vector limn_Blend3(Vector b, Vector s) { return b / (1.0 - clamp(s, 1e-6, 1.0 - 1e-6)); } \
    Vector limn_Blend4(Vector b, Vector s) { return b / (s + 1e-12); } \
    Vector limn_Blend5(Vector b, Vector s) { return s + b - 2.0 * s * b; } \
    Vector limn_Blend6(Vector b, Vector s) \
    { \
        return lerp(2.0 * b * s, 1.0 - 2.0 * (1.0 - b) * (1.0 - s), step(0.5, s)); \
    } \
    Vector limn_Blend7(Vector b, Vector s) { return step(1 - b, s); } \
    Vector limn_Blend8(Vector b, Vector s) { return max(s, b); } \
    Vector limn_Blend9(Vector b, Vector s) { return b + s - 1.0; } \
    Vector limn_Blend10(Vector b, Vector s) { return b + s; } \
    Vector limn_Blend11(Vector b, Vector s) \
    { \
        return lerp(max(b + 2 * s - 1, 0), min(b + 2 * (s - 0.5), 1), step(0.5, s)); \
    } \
    Vector limn_Blend12(Vector b, Vector s) { return s + 2.0 * b - 1.0; } \
    Vector limn_Blend13(Vector b, Vector s) { return b * s; } \
    Vector limn_Blend14(Vector b, Vector s) { return 1.0 - abs(1.0 - s - b); } \
    Vector limn_Blend15(Vector b, Vector s) \
    { \
        return lerp(2.0 * b * s, 1.0 - 2.0 * (1.0 - b) * (1.0 - s), step(0.5, b)); \
    } \
    Vector limn_Blend16(Vector b, Vector s) \
    { \
        return lerp(min(b, 2.0 * s), max(2.0 * (s - 0.5), b), step(0.5, s)); \
    } \
    Vector limn_Blend17(Vector b, Vector s) { return 1.0 - (1.0 - s) * (1.0 - b); } \
    Vector limn_Blend18(Vector b, Vector s) \
    { \
        Vector light = sqrt(b) * (2.0 * s - 1.0) + 2.0 * b * (1.0 - s); \
        return lerp(2.0 * b * s + b * b * (1.0 - 2.0 * s), light, step(0.5, s)); \
    } \
    Vector limn_Blend19(Vector b, Vector s) { return b - s; } \
    Vector limn_Blend20(Vector b, Vector s) \
    { \
        s = clamp(s, 1e-6, 1.0 - 1e-6); \
        return lerp(1.0 - (1.0 - b) / (2.0 * s), b / (2.0 * (1.0 - s)), step(0.5, s)); \
    } \
    Vector limn_Blend21(Vector b, Vector s) { return s; }
limn_FOR_VECTORS(limn_BLEND_MODES)

float3 limn_HueShift(float3 c, float offset)
{
    float3 hsv = RgbToHsv(c);
    return HsvToRgb(float3(frac(hsv.x + offset), hsv.yz));
}
// By the white point in the cones' space (CIECAT02's L, M and S).
float3 limn_WhiteBalanced(float3 c, float temperature, float tint)
{
    float warm = temperature * 10.0 / 6.0;
    float x = 0.31271 - warm * (warm < 0 ? 0.1 : 0.05);
    float y = 2.87 * x - 3 * x * x - 0.27509507 + tint * 10.0 / 6.0 * 0.05;
    float3 xyz = float3(x, y, 1 - x - y) / y;
    float3 lms = float3(dot(xyz, float3(0.7328, 0.4296, -0.1624)),
                        dot(xyz, float3(-0.7036, 1.6975, 0.0061)),
                        dot(xyz, float3(0.0030, 0.0136, 0.9834)));
    return WhiteBalance(c, float3(0.949237, 1.03542, 1.08728) / lms);
}

// ---- Normals

float3 limn_ReorientedNormal(float3 a, float3 b)
{
    float3 t = a + float3(0, 0, 1);
    float3 u = b * float3(-1, -1, 1);
    return t / t.z * dot(t, u) - u;
}
// Mikkelsen's bump mapping of surfaces without coordinates.
float3 limn_WorldNormalFromHeight(float height, float strength, float3 positionWS, float3 normalWS)
{
    float3 alongX = ddx(positionWS);
    float3 alongY = ddy(positionWS);
    float3 crossX = cross(normalWS, alongX);
    float3 crossY = cross(alongY, normalWS);
    float area = dot(alongX, crossY);
    float side = area < 0 ? -1 : 1;
    float3 gradient = side * (ddx(height) * crossY + ddy(height) * crossX);
    return SafeNormalize(max(abs(area), 1.175494351e-38) * normalWS - strength * gradient);
}
float3 limn_NormalFromHeight(float height, float strength, float3 positionWS, float3 normalWS,
                             float3x3 tangentToWorld)
{
    return TransformWorldToTangent(
        limn_WorldNormalFromHeight(height, strength, positionWS, normalWS), tangentToWorld);
}
float3 limn_NormalFromTexture(Texture2D tex, SamplerState state, float2 uv, float offset,
                              float strength)
{
    float step = pow(offset, 3) * 0.1;
    float here = SAMPLE_TEXTURE2D(tex, state, uv).r;
    float right = SAMPLE_TEXTURE2D(tex, state, uv + float2(step, 0)).r;
    float above = SAMPLE_TEXTURE2D(tex, state, uv + float2(0, step)).r;
    return normalize(cross(float3(1, 0, (right - here) * strength),
                           float3(0, 1, (above - here) * strength)));
}

// ---- Textures

UnityTexture2D limn_WithoutTransform(UnityTexture2D of)
{
    return limn_UnityTexture2D(of.tex, of.samplerstate, of.texelSize, float4(1, 1, 0, 0));
}
float3 limn_TriplanarWeights(float3 normal, float blend)
{
    float3 weights = SafePositivePow(abs(normal), max(blend, 0));
    return weights / dot(weights, 1.0);
}
float4 limn_Triplanar(Texture2D tex, SamplerState state, float3 at, float3 weights)
{
    return SAMPLE_TEXTURE2D(tex, state, at.zy) * weights.x +
        SAMPLE_TEXTURE2D(tex, state, at.xz) * weights.y +
        SAMPLE_TEXTURE2D(tex, state, at.xy) * weights.z;
}
// Whiteout blending of the three projections, as a normal in the tangent's space.
float4 limn_TriplanarNormal(Texture2D tex, SamplerState state, float3 at, float3 weights,
                            float3 normal, float3x3 tangentToWorld)
{
    float3 x = UnpackNormal(SAMPLE_TEXTURE2D(tex, state, at.zy));
    float3 y = UnpackNormal(SAMPLE_TEXTURE2D(tex, state, at.xz));
    float3 z = UnpackNormal(SAMPLE_TEXTURE2D(tex, state, at.xy));
    x = float3(x.xy + normal.zy, abs(x.z) * normal.x);
    y = float3(y.xy + normal.xz, abs(y.z) * normal.y);
    z = float3(z.xy + normal.xy, abs(z.z) * normal.z);
    float3 blended = normalize(x.zyx * weights.x + y.xzy * weights.y + z.xyz * weights.z);
    return float4(TransformWorldToTangent(blended, tangentToWorld), 1);
}

// How the four layers of a terrain (TerrainLitInput.hlsl) become one surface.
#pragma once

// The terrain's tangents follow its x.
void limn_TerrainFrame(float3 normalOS, float3 positionWS, out half4 normal, out half4 tangent,
                       out half4 bitangent)
{
    half3 view = GetWorldSpaceNormalizeViewDir(positionWS);
    VertexNormalInputs frame =
        GetVertexNormalInputs(normalOS, float4(cross(float3(0, 0, 1), normalOS), 1.0));
    normal = half4(frame.normalWS, view.x);
    tangent = half4(frame.tangentWS, view.y);
    bitangent = half4(frame.bitangentWS, view.z);
}

void SplatmapFinalColor(inout half4 color, half fogCoord)
{
    half3 weighted = color.a * color.rgb;
#if defined(TERRAIN_GBUFFER)
    // The fog comes when the light does.
#elif defined(TERRAIN_SPLAT_ADDPASS)
    weighted = MixFogColor(weighted, half3(0, 0, 0), fogCoord); // the first pass has the fog
#else
    weighted = MixFog(weighted, fogCoord);
#endif
    color.rgb = weighted;
}

#ifndef TERRAIN_SPLAT_BASEPASS
// Texels of the control texture lie at the corners of the terrain.
half4 limn_TerrainControl(float2 uv)
{
    uv = (uv * (_Control_TexelSize.zw - 1.0) + 0.5) * _Control_TexelSize.xy;
    return SAMPLE_TEXTURE2D(_Control, sampler_Control, uv);
}

void NormalMapMix(float4 uvSplat01, float4 uvSplat23, inout half4 splatControl,
                  inout half3 mixedNormal)
{
#ifdef _NORMALMAP
#define limn_LAYER_NORMAL(i, uv) \
    UnpackNormalScale(SAMPLE_TEXTURE2D(_Normal##i, sampler_Normal0, uv), _NormalScale##i)
    half3 sum = limn_LAYER_NORMAL(0, uvSplat01.xy) * splatControl.r;
    sum += limn_LAYER_NORMAL(1, uvSplat01.zw) * splatControl.g;
    sum += limn_LAYER_NORMAL(2, uvSplat23.xy) * splatControl.b;
    sum += limn_LAYER_NORMAL(3, uvSplat23.zw) * splatControl.a;
#undef limn_LAYER_NORMAL
    mixedNormal = normalize(sum + half3(0, 0, 1e-5)); // where all of them are 0
#endif
}

// The layers' alpha, where it is a density rather than smoothness: what is dense shows first.
half4 limn_TerrainDensity(half4 alpha, half4 control)
{
    half4 density = saturate((alpha + control - 1.0) * 20.0) + 0.001 * control;
    half4 isOff = half4(_DiffuseRemapScale0.w, _DiffuseRemapScale1.w, _DiffuseRemapScale2.w,
                        _DiffuseRemapScale3.w);
    return lerp(density, control, isOff);
}

void SplatmapMix(float4 uvMainAndLM, float4 uvSplat01, float4 uvSplat23, inout half4 splatControl,
                 out half weight, out half4 mixedDiffuse, out half4 defaultSmoothness,
                 inout half3 mixedNormal)
{
    half4 a = SAMPLE_TEXTURE2D(_Splat0, sampler_Splat0, uvSplat01.xy);
    half4 b = SAMPLE_TEXTURE2D(_Splat1, sampler_Splat0, uvSplat01.zw);
    half4 c = SAMPLE_TEXTURE2D(_Splat2, sampler_Splat0, uvSplat23.xy);
    half4 d = SAMPLE_TEXTURE2D(_Splat3, sampler_Splat0, uvSplat23.zw);
    half4 alpha = half4(a.a, b.a, c.a, d.a);
    defaultSmoothness = alpha * half4(_Smoothness0, _Smoothness1, _Smoothness2, _Smoothness3);
#ifndef _TERRAIN_BLEND_HEIGHT
    if (_NumLayersCount <= 4)
    {
        splatControl = limn_TerrainDensity(alpha, splatControl);
    }
#endif
    weight = dot(splatControl, 1.0);
#ifdef TERRAIN_SPLAT_ADDPASS
    clip(weight <= 0.005 ? -1.0 : 1.0);
#endif
#ifndef _TERRAIN_BASEMAP_GEN
    splatControl /= weight + HALF_MIN; // the surface is lit whole, and weighed then
#endif
    half3 color = a.rgb * _DiffuseRemapScale0.rgb * splatControl.r;
    color += b.rgb * _DiffuseRemapScale1.rgb * splatControl.g;
    color += c.rgb * _DiffuseRemapScale2.rgb * splatControl.b;
    color += d.rgb * _DiffuseRemapScale3.rgb * splatControl.a;
    mixedDiffuse = half4(color, dot(alpha, 1.0));
    NormalMapMix(uvSplat01, uvSplat23, splatControl, mixedNormal);
}

#ifdef _TERRAIN_BLEND_HEIGHT
// The highest layer shows, and those less than a transition below it.
void HeightBasedSplatModify(inout half4 splatControl, in half4 masks[4])
{
    half4 heights = splatControl * half4(masks[0].b, masks[1].b, masks[2].b, masks[3].b);
    half highest = max(max(heights.r, heights.g), max(heights.b, heights.a));
    half4 seen = max(0, heights - highest + max(_HeightTransition, 1e-5));
    seen = (seen + 1e-6) * splatControl; // some layer always shows
    splatControl = seen / max(dot(seen, 1.0), 1e-6);
}
#endif

// Metallic, occlusion, height and smoothness of each layer
void limn_TerrainMasks(out half4 masks[4], half4 hasMask, float4 uvSplat01, float4 uvSplat23)
{
    half4 a = 0.5;
    half4 b = 0.5;
    half4 c = 0.5;
    half4 d = 0.5;
#ifdef _MASKMAP
    a = lerp(a, SAMPLE_TEXTURE2D(_Mask0, sampler_Mask0, uvSplat01.xy), hasMask.x);
    b = lerp(b, SAMPLE_TEXTURE2D(_Mask1, sampler_Mask0, uvSplat01.zw), hasMask.y);
    c = lerp(c, SAMPLE_TEXTURE2D(_Mask2, sampler_Mask0, uvSplat23.xy), hasMask.z);
    d = lerp(d, SAMPLE_TEXTURE2D(_Mask3, sampler_Mask0, uvSplat23.zw), hasMask.w);
#endif
    masks[0] = a * _MaskMapRemapScale0 + _MaskMapRemapOffset0;
    masks[1] = b * _MaskMapRemapScale1 + _MaskMapRemapOffset1;
    masks[2] = c * _MaskMapRemapScale2 + _MaskMapRemapOffset2;
    masks[3] = d * _MaskMapRemapScale3 + _MaskMapRemapOffset3;
}

// Layers without a mask have the material's values.
void limn_MixTerrainMasks(half4 masks[4], half4 hasMask, half4 control, half4 smoothness,
                          inout SurfaceData surface)
{
    half4 metallic = half4(_Metallic0, _Metallic1, _Metallic2, _Metallic3);
    half4 occlusion = half4(_MaskMapRemapScale0.g + _MaskMapRemapOffset0.g,
                            _MaskMapRemapScale1.g + _MaskMapRemapOffset1.g,
                            _MaskMapRemapScale2.g + _MaskMapRemapOffset2.g,
                            _MaskMapRemapScale3.g + _MaskMapRemapOffset3.g);
#define limn_OF_MASKS(c) half4(masks[0].c, masks[1].c, masks[2].c, masks[3].c)
    surface.metallic = dot(control, lerp(metallic, limn_OF_MASKS(r), hasMask));
    surface.occlusion = dot(control, lerp(occlusion, limn_OF_MASKS(g), hasMask));
    surface.smoothness = dot(control, lerp(smoothness, limn_OF_MASKS(a), hasMask));
#undef limn_OF_MASKS
}
#endif

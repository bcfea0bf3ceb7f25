// SampleUVMappingInternal.hlsl includes this for each way to store a normal. With SURFACE_GRADIENT the
// result is a surface gradient in world space, else a normal: in tangent space, but in world space from
// three sides.
#ifdef ADD_NORMAL_FUNC_SUFFIX

float3 ADD_FUNC_SUFFIX(ADD_NORMAL_FUNC_SUFFIX(SampleUVMappingNormal))(
    TEXTURE2D_PARAM(textureName, samplerName), UVMapping uvMapping, float scale, float param)
{
#define limn_TEXEL(uv) SAMPLE_TEXTURE_FUNC(textureName, samplerName, uv, param)
#ifdef SURFACE_GRADIENT
    if (uvMapping.mappingType == UV_MAPPING_TRIPLANAR)
    {
        return SurfaceGradientFromTriplanarProjection(
            uvMapping.normalWS, uvMapping.triplanarWeights,
            UNPACK_DERIVATIVE_FUNC(limn_TEXEL(uvMapping.uvZY), scale),
            UNPACK_DERIVATIVE_FUNC(limn_TEXEL(uvMapping.uvXZ), scale),
            UNPACK_DERIVATIVE_FUNC(limn_TEXEL(uvMapping.uvXY), scale));
    }
    float2 slope = UNPACK_DERIVATIVE_FUNC(limn_TEXEL(uvMapping.uv), scale);
    if (uvMapping.mappingType == UV_MAPPING_PLANAR)
    {
        // From above: over x and z
        return SurfaceGradientFromVolumeGradient(uvMapping.normalWS,
                                                 float3(slope.x, 0.0, slope.y));
    }
    return SurfaceGradientFromTBN(slope, uvMapping.tangentWS, uvMapping.bitangentWS);
#else
    if (uvMapping.mappingType == UV_MAPPING_TRIPLANAR)
    {
        // Each side's normal, tilted by the surface's and turned to where the side looks
        float3 n = uvMapping.normalWS;
        float3 zy = UNPACK_NORMAL_FUNC(limn_TEXEL(uvMapping.uvZY), scale);
        float3 xz = UNPACK_NORMAL_FUNC(limn_TEXEL(uvMapping.uvXZ), scale);
        float3 xy = UNPACK_NORMAL_FUNC(limn_TEXEL(uvMapping.uvXY), scale);
        zy = float3(zy.xy + n.zy, abs(zy.z) * n.x);
        xz = float3(xz.xy + n.xz, abs(xz.z) * n.y);
        xy = float3(xy.xy + n.xy, abs(xy.z) * n.z);
        return normalize(zy.zyx * uvMapping.triplanarWeights.x +
                         xz.xzy * uvMapping.triplanarWeights.y +
                         xy * uvMapping.triplanarWeights.z);
    }
    return UNPACK_NORMAL_FUNC(limn_TEXEL(uvMapping.uv), scale);
#endif
#undef limn_TEXEL
}

#endif

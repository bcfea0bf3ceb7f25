// SampleUVMapping.hlsl includes this for each way to sample; param is the level or the bias.
#ifdef ADD_FUNC_SUFFIX

float4 ADD_FUNC_SUFFIX(SampleUVMapping)(TEXTURE2D_PARAM(textureName, samplerName),
                                        UVMapping uvMapping, float param)
{
    if (uvMapping.mappingType != UV_MAPPING_TRIPLANAR)
    {
        return SAMPLE_TEXTURE_FUNC(textureName, samplerName, uvMapping.uv, param);
    }
    float3 weights = uvMapping.triplanarWeights;
    float4 sum = SAMPLE_TEXTURE_FUNC(textureName, samplerName, uvMapping.uvZY, param) * weights.x;
    sum += SAMPLE_TEXTURE_FUNC(textureName, samplerName, uvMapping.uvXZ, param) * weights.y;
    return sum + SAMPLE_TEXTURE_FUNC(textureName, samplerName, uvMapping.uvXY, param) * weights.z;
}

#define ADD_NORMAL_FUNC_SUFFIX(Name) Name
#define UNPACK_NORMAL_FUNC UnpackNormalmapRGorAG
#define UNPACK_DERIVATIVE_FUNC UnpackDerivativeNormalRGorAG
#include "SampleUVMappingNormalInternal.hlsl"
#undef ADD_NORMAL_FUNC_SUFFIX
#undef UNPACK_NORMAL_FUNC
#undef UNPACK_DERIVATIVE_FUNC
#define ADD_NORMAL_FUNC_SUFFIX(Name) MERGE_NAME(Name, AG)
#define UNPACK_NORMAL_FUNC UnpackNormalAG
#define UNPACK_DERIVATIVE_FUNC UnpackDerivativeNormalAG
#include "SampleUVMappingNormalInternal.hlsl"
#undef ADD_NORMAL_FUNC_SUFFIX
#undef UNPACK_NORMAL_FUNC
#undef UNPACK_DERIVATIVE_FUNC
#define ADD_NORMAL_FUNC_SUFFIX(Name) MERGE_NAME(Name, RGB)
#define UNPACK_NORMAL_FUNC UnpackNormalRGB
#define UNPACK_DERIVATIVE_FUNC UnpackDerivativeNormalRGB
#include "SampleUVMappingNormalInternal.hlsl"
#undef ADD_NORMAL_FUNC_SUFFIX
#undef UNPACK_NORMAL_FUNC
#undef UNPACK_DERIVATIVE_FUNC

#endif

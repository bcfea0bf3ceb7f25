// Depth and normals of particles that are cut out.
#pragma once
#ifndef UNIVERSAL_PARTICLES_LIT_DEPTH_NORMALS_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_LIT_DEPTH_NORMALS_PASS_INCLUDED
#include "limn/ParticleDepth.hlsl"

VaryingsDepthNormalsParticle DepthNormalsVertex(AttributesDepthNormalsParticle input)
{
    VaryingsDepthNormalsParticle output = (VaryingsDepthNormalsParticle)0;
    limn_TRANSFER_PARTICLE(input, output)
    VertexNormalInputs frame = GetVertexNormalInputs(input.normal, input.tangent);
    output.normalWS = frame.normalWS;
#ifdef _NORMALMAP
    output.tangentWS = frame.tangentWS;
    output.bitangentWS = frame.bitangentWS;
#endif
    return output;
}
half4 DepthNormalsFragment(VaryingsDepthNormalsParticle input) : SV_Target
{
    limn_CLIP_PARTICLE(input)
    float3 normal = input.normalWS;
#ifdef _NORMALMAP
    float3 normalTS =
        SampleNormalTS(input.texcoord, limn_PARTICLE_BLEND(input),
                       TEXTURE2D_ARGS(_BumpMap, sampler_BumpMap), _BumpScale);
    normal = TransformTangentToWorld(
        normalTS, float3x3(input.tangentWS, input.bitangentWS, input.normalWS));
#endif
    return half4(NormalizeNormalPerPixel(normal), 0.0);
}
#endif

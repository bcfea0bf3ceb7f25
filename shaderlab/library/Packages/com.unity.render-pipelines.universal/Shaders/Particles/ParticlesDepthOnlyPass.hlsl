// Depth of particles that are cut out.
#pragma once
#ifndef UNIVERSAL_PARTICLES_LIT_DEPTH_ONLY_PASS_INCLUDED
#define UNIVERSAL_PARTICLES_LIT_DEPTH_ONLY_PASS_INCLUDED
#include "limn/ParticleDepth.hlsl"

VaryingsDepthOnlyParticle DepthOnlyVertex(AttributesDepthOnlyParticle input)
{
    VaryingsDepthOnlyParticle output = (VaryingsDepthOnlyParticle)0;
    limn_TRANSFER_PARTICLE(input, output)
    return output;
}
half DepthOnlyFragment(VaryingsDepthOnlyParticle input) : SV_Target
{
    limn_CLIP_PARTICLE(input)
    return input.clipPos.z;
}
#endif

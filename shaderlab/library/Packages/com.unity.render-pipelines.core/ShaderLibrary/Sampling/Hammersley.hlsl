// Points that fill a square evenly: the second number is the first one's bits the other way round.
#pragma once
#ifndef UNITY_HAMMERSLEY_INCLUDED
#define UNITY_HAMMERSLEY_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

uint ReverseBits32(uint bits) { return reversebits(bits); }
float VanDerCorputBase2(uint i) { return ReverseBits32(i) * (1.0 / 4294967296.0); }
float2 Hammersley2dSeq(uint i, uint sequenceLength)
{
    return float2((float)i / (float)sequenceLength, VanDerCorputBase2(i));
}
float2 Hammersley2d(uint i, uint sampleCount) { return Hammersley2dSeq(i, sampleCount); }
#endif

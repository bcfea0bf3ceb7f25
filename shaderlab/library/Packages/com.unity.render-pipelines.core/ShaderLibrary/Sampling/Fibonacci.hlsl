// Points that fill a square evenly, by Fibonacci's numbers or the golden ratio.
#pragma once
#ifndef UNITY_FIBONACCI_INCLUDED
#define UNITY_FIBONACCI_INCLUDED
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"

#define GOLDEN_RATIO 1.618033988749895
#define GOLDEN_ANGLE 2.399963229728653
static const uint k_FibonacciSeq[] = {0,  1,  1,   2,   3,   5,   8,   13,   21,   34,
                                      55, 89, 144, 233, 377, 610, 987, 1597, 2584, 4181};

// fibN1: the number of points; fibN2: the number of Fibonacci's before it
float2 Fibonacci2dSeq(float fibN1, float fibN2, uint i)
{
    return float2((i + 0.5) / fibN1, frac(i * (fibN2 / fibN1)));
}
float2 Golden2dSeq(uint i, float n)
{
    return float2((i + 0.5) / n, frac(i * (1.0 / GOLDEN_RATIO)));
}
// sampleCount: one of Fibonacci's numbers
float2 Fibonacci2d(uint i, uint sampleCount)
{
    uint before = sampleCount;
    for (uint j = 2u; j < 20u; ++j)
    {
        before = k_FibonacciSeq[j] == sampleCount ? k_FibonacciSeq[j - 1u] : before;
    }
    return Fibonacci2dSeq(sampleCount, before, i);
}

// Radius or cosine of the polar angle, and angle in the plane.
float2 SampleDiskGolden(uint i, uint sampleCount)
{
    float2 f = Golden2dSeq(i, sampleCount);
    return float2(sqrt(f.x), TWO_PI * f.y);
}
float2 SampleDiskFibonacci(uint i, uint sampleCount)
{
    float2 f = Fibonacci2d(i, sampleCount);
    return float2(sqrt(f.x), TWO_PI * f.y);
}
float2 SampleHemisphereFibonacci(uint i, uint sampleCount)
{
    float2 f = Fibonacci2d(i, sampleCount);
    return float2(1.0 - f.x, TWO_PI * f.y);
}
float2 SampleSphereFibonacci(uint i, uint sampleCount)
{
    float2 f = Fibonacci2d(i, sampleCount);
    return float2(1.0 - 2.0 * f.x, TWO_PI * f.y);
}
#endif

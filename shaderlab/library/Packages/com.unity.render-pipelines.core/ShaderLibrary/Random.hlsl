// Numbers that look random and are the same on every run.
#pragma once
#ifndef UNITY_RANDOM_INCLUDED
#define UNITY_RANDOM_INCLUDED

// Bob Jenkins' one-at-a-time hash over the bits of a number, and of several in turn.
uint JenkinsHash(uint x)
{
    x += x << 10;
    x ^= x >> 6;
    x += x << 3;
    x ^= x >> 11;
    x += x << 15;
    return x;
}
uint JenkinsHash(uint2 v) { return JenkinsHash(v.x ^ JenkinsHash(v.y)); }
uint JenkinsHash(uint3 v) { return JenkinsHash(v.x ^ JenkinsHash(v.yz)); }
uint JenkinsHash(uint4 v) { return JenkinsHash(v.x ^ JenkinsHash(v.yzw)); }

// The low 23 bits as a number in 0...1 without 1; of a signed one in -1...1.
float ConstructFloat(uint m) { return asfloat((m & 0x007FFFFFu) | 0x3F800000u) - 1.0; }
float ConstructFloat(int m)
{
    uint bits = (uint)m;
    return asfloat((bits & 0x807FFFFFu) | 0x3F800000u) + ((bits >> 31) != 0 ? 1.0 : -1.0);
}

float GenerateHashedRandomFloat(uint x) { return ConstructFloat(JenkinsHash(x)); }
float GenerateHashedRandomFloat(uint2 v) { return ConstructFloat(JenkinsHash(v)); }
float GenerateHashedRandomFloat(uint3 v) { return ConstructFloat(JenkinsHash(v)); }
float GenerateHashedRandomFloat(uint4 v) { return ConstructFloat(JenkinsHash(v)); }

// Jorge Jimenez 2014: noise whose values of neighbouring pixels are spread evenly; another one per
// frame.
float InterleavedGradientNoise(float2 pixCoord, int frameCount)
{
    pixCoord += (float)frameCount * (float2(47.0, 17.0) * 0.695);
    return frac(52.9829189 * frac(dot(pixCoord, float2(0.06711056, 0.00583715))));
}

// George Marsaglia's xorshift.
uint XorShift(inout uint rngState)
{
    rngState ^= rngState << 13;
    rngState ^= rngState >> 17;
    rngState ^= rngState << 5;
    return rngState;
}
#endif

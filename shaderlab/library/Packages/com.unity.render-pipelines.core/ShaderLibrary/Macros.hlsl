#pragma once
#ifndef UNITY_MACROS_INCLUDED
#define UNITY_MACROS_INCLUDED

#define PI 3.14159265358979323846
#define TWO_PI 6.28318530717958647693
#define FOUR_PI 12.5663706143591729538
#define HALF_PI 1.57079632679489661923
#define PI_DIV_FOUR 0.78539816339744830962
#define INV_PI 0.31830988618379067154
#define INV_TWO_PI 0.15915494309189533577
#define INV_FOUR_PI 0.07957747154594766788
#define INV_HALF_PI 0.63661977236758134308
#define LOG2_E 1.44269504088896340736
#define INV_SQRT2 0.70710678118654752440

#define FLT_EPSILON 1.192092896e-07
#define FLT_EPS 5.960464478e-8
#define FLT_MIN 1.175494351e-38
#define FLT_MAX 3.402823466e+38
#define FLT_INF asfloat(0x7F800000)
#define FLT_NAN asfloat(0xFFFFFFFF)
#define HALF_EPS 4.8828125e-4
#define HALF_MIN 6.103515625e-5
#define HALF_MIN_SQRT 0.0078125
#define HALF_MAX 65504.0
#define UINT_MAX 0xFFFFFFFFu
#define INT_MAX 0x7FFFFFFF

#define MILLIMETERS_PER_METER 1000
#define METERS_PER_MILLIMETER 0.001
#define CENTIMETERS_PER_METER 100
#define METERS_PER_CENTIMETER 0.01

// Faces of a cube map in the order they are stored.
#define CUBEMAPFACE_POSITIVE_X 0
#define CUBEMAPFACE_NEGATIVE_X 1
#define CUBEMAPFACE_POSITIVE_Y 2
#define CUBEMAPFACE_NEGATIVE_Y 3
#define CUBEMAPFACE_POSITIVE_Z 4
#define CUBEMAPFACE_NEGATIVE_Z 5

#define MERGE_NAME(a, b) a##b
#define CALL_MERGE_NAME(a, b) MERGE_NAME(a, b)
#define SAFE_DIVIDE(a, b) ((b) != 0 ? (a) / (b) : 0)
#define GET_TEXELSIZE_NAME(name) (name##_TexelSize)

// A function of scalars, and the same of 2 to 4 components. half and real are float here.
#define limn_FUNCTION_1(T, name, a, body) T name(T a) { body; }
#define limn_FUNCTION_2(T, name, a, b, body) T name(T a, T b) { body; }
#define limn_FUNCTION_3(T, name, a, b, c, body) T name(T a, T b, T c) { body; }
#define limn_FUNCTION_SWAP(T, name) void name(inout T a, inout T b) { T kept = a; a = b; b = kept; }
#define TEMPLATE_1_FLT(name, a, body) \
    limn_FUNCTION_1(float, name, a, body) \
    limn_FUNCTION_1(float2, name, a, body) \
    limn_FUNCTION_1(float3, name, a, body) \
    limn_FUNCTION_1(float4, name, a, body)
#define TEMPLATE_1_INT(name, a, body) \
    limn_FUNCTION_1(int, name, a, body) \
    limn_FUNCTION_1(int2, name, a, body) \
    limn_FUNCTION_1(int3, name, a, body) \
    limn_FUNCTION_1(int4, name, a, body) \
    limn_FUNCTION_1(uint, name, a, body) \
    limn_FUNCTION_1(uint2, name, a, body) \
    limn_FUNCTION_1(uint3, name, a, body) \
    limn_FUNCTION_1(uint4, name, a, body)
#define TEMPLATE_1_REAL TEMPLATE_1_FLT
#define TEMPLATE_1_FLT_HALF TEMPLATE_1_FLT
#define TEMPLATE_2_FLT(name, a, b, body) \
    limn_FUNCTION_2(float, name, a, b, body) \
    limn_FUNCTION_2(float2, name, a, b, body) \
    limn_FUNCTION_2(float3, name, a, b, body) \
    limn_FUNCTION_2(float4, name, a, b, body)
#define TEMPLATE_2_INT(name, a, b, body) \
    limn_FUNCTION_2(int, name, a, b, body) \
    limn_FUNCTION_2(int2, name, a, b, body) \
    limn_FUNCTION_2(int3, name, a, b, body) \
    limn_FUNCTION_2(int4, name, a, b, body) \
    limn_FUNCTION_2(uint, name, a, b, body) \
    limn_FUNCTION_2(uint2, name, a, b, body) \
    limn_FUNCTION_2(uint3, name, a, b, body) \
    limn_FUNCTION_2(uint4, name, a, b, body)
#define TEMPLATE_2_REAL TEMPLATE_2_FLT
#define TEMPLATE_2_FLT_HALF TEMPLATE_2_FLT
#define TEMPLATE_3_FLT(name, a, b, c, body) \
    limn_FUNCTION_3(float, name, a, b, c, body) \
    limn_FUNCTION_3(float2, name, a, b, c, body) \
    limn_FUNCTION_3(float3, name, a, b, c, body) \
    limn_FUNCTION_3(float4, name, a, b, c, body)
#define TEMPLATE_3_INT(name, a, b, c, body) \
    limn_FUNCTION_3(int, name, a, b, c, body) \
    limn_FUNCTION_3(int2, name, a, b, c, body) \
    limn_FUNCTION_3(int3, name, a, b, c, body) \
    limn_FUNCTION_3(int4, name, a, b, c, body) \
    limn_FUNCTION_3(uint, name, a, b, c, body) \
    limn_FUNCTION_3(uint2, name, a, b, c, body) \
    limn_FUNCTION_3(uint3, name, a, b, c, body) \
    limn_FUNCTION_3(uint4, name, a, b, c, body)
#define TEMPLATE_3_REAL TEMPLATE_3_FLT
#define TEMPLATE_3_FLT_HALF TEMPLATE_3_FLT
#define TEMPLATE_SWAP(name) \
    limn_FUNCTION_SWAP(float, name) \
    limn_FUNCTION_SWAP(float2, name) \
    limn_FUNCTION_SWAP(float3, name) \
    limn_FUNCTION_SWAP(float4, name) \
    limn_FUNCTION_SWAP(int, name) \
    limn_FUNCTION_SWAP(int2, name) \
    limn_FUNCTION_SWAP(int3, name) \
    limn_FUNCTION_SWAP(int4, name) \
    limn_FUNCTION_SWAP(uint, name) \
    limn_FUNCTION_SWAP(uint2, name) \
    limn_FUNCTION_SWAP(uint3, name) \
    limn_FUNCTION_SWAP(uint4, name) \
    limn_FUNCTION_SWAP(bool, name) \
    limn_FUNCTION_SWAP(bool2, name) \
    limn_FUNCTION_SWAP(bool3, name) \
    limn_FUNCTION_SWAP(bool4, name)
#endif

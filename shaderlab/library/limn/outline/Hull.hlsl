// The hull around an object whose thickness holds on the screen: each vertex moves by so many pixels
// across the silhouette that its outline normal makes there. Behind Core.hlsl.
#pragma once

// Object to world for normals, by the cofactors: unlike the inverse they exist for every
// scale. A scale of zero in one axis leaves one direction of them only; there the outline
// is that of a flat figure, whose normals go like directions within it.
float3 OutlineNormalToWorld(float3 n)
{
    float3x3 columns = transpose((float3x3)UNITY_MATRIX_M);
    float3 x = columns[0];
    float3 y = columns[1];
    float3 z = columns[2];
    float3 largest = max(abs(x), max(abs(y), abs(z)));
    float unit = 1.0 / max(max(largest.x, max(largest.y, largest.z)), 1e-30);
    x *= unit;
    y *= unit;
    z *= unit;
    float volume = dot(x, cross(y, z));
    float3 flat = x * n.x + y * n.y + z * n.z;
    float3 upright = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
    return abs(volume) < 1e-9 ? flat : upright * unity_WorldTransformParams.w;
}

// How a point that moves by v moves on the screen, in pixels times an unknown factor.
float2 HullMovement(float3 v, float4 positionCS)
{
    float4 moved = mul(UNITY_MATRIX_P, float4(v, 0.0));
    return (moved.xy * positionCS.w - positionCS.xy * moved.w) * _ScreenParams.xy;
}

// Across the silhouette, in pixels times an unknown factor. The plane that touches the
// object there goes through the camera, so it is a line on the screen: this is its normal,
// which is not where the surface's normal seems to point unless it is seen head on.
float2 AcrossSilhouette(float3 normalVS)
{
    return normalVS.xy / (float2(UNITY_MATRIX_P._m00, UNITY_MATRIX_P._m11) * _ScreenParams.xy);
}

// A vertex of the hull of a thickness in pixels.
// outlineOS: what BakeOutlineNormals gives; zero where it has none
float4 HullPosition(float3 positionOS, float3 normalOS, float3 outlineOS, float width)
{
    outlineOS = dot(outlineOS, outlineOS) > 0.0 ? outlineOS : normalOS;
    float miter = length(outlineOS);
    float3 positionVS = mul(UNITY_MATRIX_MV, float4(positionOS, 1.0)).xyz;
    float3 normalVS = SafeNormalize(mul((float3x3)UNITY_MATRIX_V, OutlineNormalToWorld(outlineOS)));
    float4 positionCS = mul(UNITY_MATRIX_P, float4(positionVS, 1.0));
    bool orthographic = unity_OrthoParams.w > 0.5;

    // There is no place on the screen for what is behind the camera: there the hull is
    // moved in space, by the size that a pixel has at the near plane.
    if (!orthographic && positionCS.w < _ProjectionParams.y)
    {
        float metresPerPixel =
            2.0 * _ProjectionParams.y / (abs(UNITY_MATRIX_P._m11) * _ScreenParams.y);
        positionVS += normalVS * (miter * width * metresPerPixel);
        return mul(UNITY_MATRIX_P, float4(positionVS, 1.0));
    }

    // The part of the normal across the line of sight; its length brings the miter to the
    // screen. At least 1, so that a vertex beside the silhouette is not left behind.
    float3 sight = orthographic ? float3(0.0, 0.0, -1.0) : SafeNormalize(positionVS);
    float along = dot(normalVS, sight);
    float reach = max(1.0, miter * sqrt(saturate(1.0 - along * along)));
    float2 direction = AcrossSilhouette(normalVS);
    if (dot(normalVS.xy, normalVS.xy) < 1e-6)
    {
        // It points along the view axis: away from the object's middle then.
        float3 middleVS = mul(UNITY_MATRIX_MV, float4(0.0, 0.0, 0.0, 1.0)).xyz;
        direction = HullMovement(positionVS - middleVS, positionCS);
        reach = 1.0;
    }
    direction *= rsqrt(max(dot(direction, direction), 1e-30));
    positionCS.xy += direction * (reach * width * 2.0 * positionCS.w) / _ScreenParams.xy;
    return positionCS;
}

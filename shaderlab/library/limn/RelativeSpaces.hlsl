// Far away from the world's origin a float is too coarse for a world position: 1 m at 1e7 m. What
// leads to the picture therefore goes over positions relative to limn_Origin, which is
// near the camera there.
// Near the world's origin limn_Origin is 0 and all of this the same, to the last bit, as with
// unity_ObjectToWorld, unity_MatrixV and unity_MatrixVP.
#pragma once

float4x4 limn_Moved(float4x4 m, float4 translation)
{
    return float4x4(float4(m[0].xyz, translation.x), float4(m[1].xyz, translation.y),
                    float4(m[2].xyz, translation.z), float4(m[3].xyz, translation.w));
}

float4x4 limn_RelativeM()
{
    float4x4 m = unity_ObjectToWorld;
    if (limn_Origin.w != 0.0)
    {
        m = limn_Moved(m, float4(unity_WorldTransformParams.xyz, 1.0));
    }
    return m;
}
float4x4 limn_RelativeV()
{
    float4x4 m = UNITY_MATRIX_V;
    if (limn_Origin.w != 0.0)
    {
        m = limn_Moved(m, limn_OriginVS);
    }
    return m;
}
float4x4 limn_RelativeVP()
{
    float4x4 m = UNITY_MATRIX_VP;
    if (limn_Origin.w != 0.0)
    {
        m = limn_Moved(m, limn_OriginCS);
    }
    return m;
}

float3 limn_ObjectToRelative(float3 positionOS)
{
    return mul(limn_RelativeM(), float4(positionOS, 1.0)).xyz;
}
float3 limn_RelativeToView(float3 position) { return mul(limn_RelativeV(), float4(position, 1.0)).xyz; }
float4 limn_RelativeToClip(float3 position) { return mul(limn_RelativeVP(), float4(position, 1.0)); }

// From a point of the object to the camera, along the axes of the world; not normalised.
float3 limn_ObjectToCamera(float3 positionOS)
{
    float3 camera = _WorldSpaceCameraPos;
    if (limn_Origin.w != 0.0)
    {
        camera = limn_CameraPos.xyz;
    }
    return camera - limn_ObjectToRelative(positionOS);
}

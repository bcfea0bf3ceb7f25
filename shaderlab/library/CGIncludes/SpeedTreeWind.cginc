// The wind of SpeedTrees: its names, without what it does.
#pragma once
#define SPEEDTREE_WIND_INCLUDED

cbuffer SpeedTreeWind
{
    float4 _ST_WindVector, _ST_WindGlobal, _ST_WindBranch, _ST_WindBranchTwitch, _ST_WindBranchWhip;
    float4 _ST_WindBranchAnchor, _ST_WindBranchAdherences, _ST_WindTurbulences;
    float4 _ST_WindLeaf1Ripple, _ST_WindLeaf1Tumble, _ST_WindLeaf1Twitch;
    float4 _ST_WindLeaf2Ripple, _ST_WindLeaf2Tumble, _ST_WindLeaf2Twitch;
    float4 _ST_WindFrondRipple, _ST_WindAnimation;
};

[limn_Lacks("the wind of SpeedTrees", "they stand still")]
float3 GlobalWind(float3 vPos, float3 vInstancePos, bool bPreserveShape, float3 vRotatedWindVector,
                  float time)
{
    return vPos;
}
[limn_Lacks("the wind of SpeedTrees", "they stand still")]
float3 BranchWind(bool isPalmWind, float3 vPos, float3 vInstancePos, float4 vWindData,
                  float3 vRotatedWindVector, float3 vRotatedBranchAnchor)
{
    return vPos;
}
[limn_Lacks("the wind of SpeedTrees", "they stand still")]
float3 LeafWind(bool isBestWind, bool bLeaf2, float3 vPos, inout float3 vNormal, float fScale,
                float3 vPackedGrowthDir, float fPackedRippleDir, float fRippleTrigOffset,
                float fTrigOffset, float3 vWindVector)
{
    return vPos;
}
[limn_Lacks("the wind of SpeedTrees", "they stand still")]
float3 RippleFrond(float3 vPos, inout float3 vNormal, float fU, float fV, float fRippleScale,
                   float fLenV, float fLenH)
{
    return vPos;
}

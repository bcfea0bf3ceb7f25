// The wind of SpeedTrees: how far it moves the vertices of trunk, branches, leaves and fronds. What
// feeds it is the script's: limn has no wind zones, and where nothing is set, nothing moves.
#pragma once
#ifndef SPEEDTREE_WIND_INCLUDED
#define SPEEDTREE_WIND_INCLUDED

cbuffer SpeedTreeWind
{
    float4 _ST_WindVector;           // direction; w: strength
    float4 _ST_WindGlobal;           // time, distance, 1 / height of the tree, exponent of the height
    float4 _ST_WindBranch;           // time, distance
    float4 _ST_WindBranchTwitch;     // amount, frequency
    float4 _ST_WindBranchWhip;       // x
    float4 _ST_WindBranchAnchor;     // direction; w: distance
    float4 _ST_WindBranchAdherences; // of the trunk, of branches
    float4 _ST_WindTurbulences;      // x
    float4 _ST_WindLeaf1Ripple;      // time, distance
    float4 _ST_WindLeaf1Tumble;      // time, flip, twist, adherence
    float4 _ST_WindLeaf1Twitch;      // amount, sharpness, time
    float4 _ST_WindLeaf2Ripple;
    float4 _ST_WindLeaf2Tumble;
    float4 _ST_WindLeaf2Twitch;
    float4 _ST_WindFrondRipple; // time, distance, tiles, how far it bends the normal
    float4 _ST_WindAnimation;   // x: time
};

#ifdef SPEEDTREE_Z_UP
#define limn_ST_UP z
#define limn_ST_LEVEL xy
#else
#define limn_ST_UP y
#define limn_ST_LEVEL xz
#endif
#define wind_cross(a, b) cross((a), (b))

// Three numbers of -1 to 1 that one float holds, in steps of 16, 1 and 1/16.
float3 UnpackNormalFromFloat(float fValue)
{
    return 2.0 * frac(float3(fValue * 0.0625, fValue, fValue * 16.0)) - 1.0;
}

float4 CubicSmooth(float4 vData) { return (3.0 - 2.0 * vData) * (vData * vData); }
// 0 at whole numbers, 1 half way between them.
float4 TriangleWave(float4 vData) { return abs(2.0 * frac(vData + 0.5) - 1.0); }
// About -cos(2 pi x).
float4 TrigApproximate(float4 vData) { return 2.0 * CubicSmooth(TriangleWave(vData)) - 1.0; }

float3x3 RotationMatrix(float3 vAxis, float fAngle)
{
    float s, c;
    sincos(fAngle, s, c);
    float3 turned = vAxis * s;
    float3 kept = vAxis * (1.0 - c);
    return float3x3(kept.x * vAxis + float3(c, -turned.z, turned.y),
                    kept.y * vAxis + float3(turned.z, c, -turned.x),
                    kept.z * vAxis + float3(-turned.y, turned.x, c));
}
float3x3 mul_float3x3_float3x3(float3x3 mMatrixA, float3x3 mMatrixB)
{
    return mul(mMatrixA, mMatrixB);
}
float3 mul_float3x3_float3(float3x3 mMatrix, float3 vVector) { return mul(mMatrix, vVector); }

// The vector made as long as asked for; 0 stays 0.
float3 limn_ST_OfLength(float3 v, float size) { return v * (size / max(length(v), 1e-20)); }

float Roll(float fCurrent, float fMaxScale, float fMinScale, float fSpeed, float fRipple,
           float3 vPos, float fTime, float3 vRotatedWindVector)
{
    float phase = fTime * fSpeed - dot(vPos, vRotatedWindVector) * fRipple;
    float share = 0.5 + 0.5 * TrigApproximate(phase.xxxx).x;
    return fCurrent * lerp(fMinScale, fMaxScale, share);
}

// Short jerks: the sharper, the rarer.
float Twitch(float3 vPos, float fAmount, float fSharpness, float fTime)
{
    float2 waves = TrigApproximate(float4(fTime + vPos.x + vPos.z, 0.87 * fTime + vPos.y, 0, 0)).xy;
    return fAmount * pow(saturate(0.5 + 0.5 * waves.x * waves.y * waves.y), fSharpness);
}

// How far to one side, and in vOscillations what it is made of; w is the whip's.
float Oscillate(float3 vPos, float fTime, float fOffset, float fWeight, float fWhip, bool bWhip,
                bool bRoll, bool bComplex, float fTwitch, float fTwitchFreqScale,
                inout float4 vOscillations, float3 vRotatedWindVector)
{
    float now = fTime + fOffset;
    float2 side = bComplex
                      ? float2(fTime * fTwitchFreqScale + fOffset, 0.5 * fTwitchFreqScale * now)
                      : float2(fTime * 0.689 + fOffset, 0.0);
    vOscillations = TrigApproximate(float4(now, side, bWhip ? now + 1.0 - fWeight : 0.0));

    float swing = vOscillations.x * (1.0 + vOscillations.y);
    if (bComplex)
    {
        // The slow part, drawn two steps out to its extreme.
        float slow = vOscillations.y * vOscillations.z;
        float rest = 1.0 - abs(slow);
        slow = sign(slow) * (1.0 - rest * rest * rest);
        swing = lerp(vOscillations.x, slow * (1.0 - _ST_WindVector.w), fTwitch);
    }
    return bWhip ? swing + swing * vOscillations.w * fWhip : swing;
}

float Turbulence(float fTime, float fOffset, float fGlobalTime, float fTurbulence)
{
    float2 phases = float2(fTime, fGlobalTime * fTurbulence) * 0.1 + fOffset;
    float2 waves = TrigApproximate(phases.xyxy).xy;
    float both = waves.x * waves.y;
    return 1.0 - both * both * fTurbulence;
}

// The whole tree leans, its top most. The lowest quarter of its height stands still.
float3 GlobalWind(float3 vPos, float3 vInstancePos, bool bPreserveShape, float3 vRotatedWindVector,
                  float time)
{
    float perHeight = _ST_WindGlobal.z;
    if (perHeight == 0.0)
    {
        return vPos; // nothing is set
    }
    float height = max(vPos.limn_ST_UP * perHeight - 0.25, 0.0);
    float share = height > 0.0 ? pow(height, _ST_WindGlobal.w) : 0.0;
    float2 waves = TrigApproximate(float4(vInstancePos.xy + time * float2(1.0, 0.8), 0, 0)).xy;
    float amount = (waves.x + waves.y * waves.y) * _ST_WindGlobal.y +
                   _ST_WindBranchAdherences.x / perHeight;

    float3 leant = vPos;
    leant.limn_ST_LEVEL += vRotatedWindVector.limn_ST_LEVEL * (amount * share);
    return bPreserveShape ? limn_ST_OfLength(leant, length(vPos)) : leant;
}

// A branch swings along the direction that its offset holds. Trees at other places do at other times.
float3 limn_ST_Swing(float3 vPos, float fWeight, float fOffset, float fTime, float fDistance,
                     float fTwitch, float fTwitchScale, float fWhip, bool bWhip, bool bComplex,
                     out float4 oscillations)
{
    oscillations = 0;
    float swing = Oscillate(vPos, fTime, fOffset, fWeight, fWhip, bWhip, false, bComplex, fTwitch,
                            fTwitchScale, oscillations, float3(0, 0, 0));
    return vPos + UnpackNormalFromFloat(fOffset) * (fWeight * swing * fDistance);
}
// How much of its adherence holds a branch in the wind.
float limn_ST_Hold(float fOffset, float fTime, float fTurbulence, float fWhip, bool bWhip,
                   bool bTurbulence, float whipWave)
{
    float hold =
        bTurbulence ? Turbulence(fTime, fOffset, _ST_WindAnimation.x, fTurbulence) : 1.0;
    return bWhip ? hold + whipWave * _ST_WindVector.w * fWhip : hold;
}

float3 SimpleBranchWind(float3 vPos, float3 vInstancePos, float fWeight, float fOffset, float fTime,
                        float fDistance, float fTwitch, float fTwitchScale, float fWhip, bool bWhip,
                        bool bRoll, bool bComplex, float3 vRotatedWindVector)
{
    float4 waves;
    return limn_ST_Swing(vPos, fWeight, fOffset, fTime + vInstancePos.x + vInstancePos.y, fDistance,
                         fTwitch, fTwitchScale, fWhip, bWhip, bComplex, waves);
}

// Swings, and is blown along the wind.
float3 DirectionalBranchWind(float3 vPos, float3 vInstancePos, float fWeight, float fOffset,
                             float fTime, float fDistance, float fTurbulence, float fAdherence,
                             float fTwitch, float fTwitchScale, float fWhip, bool bWhip, bool bRoll,
                             bool bComplex, bool bTurbulence, float3 vRotatedWindVector)
{
    float4 waves;
    float time = fTime + vInstancePos.x + vInstancePos.y;
    float3 swung = limn_ST_Swing(vPos, fWeight, fOffset, time, fDistance, fTwitch, fTwitchScale,
                                 fWhip, bWhip, bComplex, waves);
    float hold = limn_ST_Hold(fOffset, time, fTurbulence, fWhip, bWhip, bTurbulence, waves.w);
    return swung + vRotatedWindVector * (fAdherence * hold * fWeight);
}

// Swings, and is drawn to the anchor.
float3 DirectionalBranchWindFrondStyle(float3 vPos, float3 vInstancePos, float fWeight,
                                       float fOffset, float fTime, float fDistance,
                                       float fTurbulence, float fAdherence, float fTwitch,
                                       float fTwitchScale, float fWhip, bool bWhip, bool bRoll,
                                       bool bComplex, bool bTurbulence, float3 vRotatedWindVector,
                                       float3 vRotatedBranchAnchor)
{
    float4 waves;
    float time = fTime + vInstancePos.x + vInstancePos.y;
    float3 swung = limn_ST_Swing(vPos, fWeight, fOffset, time, fDistance, fTwitch, fTwitchScale,
                                 fWhip, bWhip, bComplex, waves);
    float hold = limn_ST_Hold(fOffset, time, fTurbulence, fWhip, bWhip, bTurbulence, waves.w);
    return lerp(swung, vRotatedBranchAnchor, fAdherence * hold * fWeight);
}

// vWindData: weight, offset.
float3 BranchWind(bool isPalmWind, float3 vPos, float3 vInstancePos, float4 vWindData,
                  float3 vRotatedWindVector, float3 vRotatedBranchAnchor)
{
    float2 twitch = _ST_WindBranchTwitch.xy;
    float time = _ST_WindBranch.x;
    float reach = _ST_WindBranch.y;
    float whip = _ST_WindBranchWhip.x;
    if (isPalmWind)
    {
        float adherence = _ST_WindBranchAdherences.y;
        return DirectionalBranchWindFrondStyle(
            vPos, vInstancePos, vWindData.x, vWindData.y, time, reach, _ST_WindTurbulences.x,
            adherence, twitch.x, twitch.y, whip, true, false, true, true, vRotatedWindVector,
            vRotatedBranchAnchor);
    }
    return SimpleBranchWind(vPos, vInstancePos, vWindData.x, vWindData.y, time, reach, twitch.x,
                            twitch.y, whip, false, false, true, vRotatedWindVector);
}

float3 LeafRipple(float3 vPos, inout float3 vDirection, float fScale, float fPackedRippleDir,
                  float fTime, float fAmount, bool bDirectional, float fTrigOffset)
{
    float3 way = vDirection;
    if (!bDirectional)
    {
        way = UnpackNormalFromFloat(fPackedRippleDir);
    }
    float wave = TrigApproximate((fTime + fTrigOffset).xxxx).x;
    return vPos + way * (fScale * fAmount * wave);
}

// A leaf twists about the way it grows and turns into the wind, about its anchor.
float3 LeafTumble(float3 vPos, inout float3 vDirection, float fScale, float3 vAnchor,
                  float3 vGrowthDir, float fTrigOffset, float fTime, float fFlip, float fTwist,
                  float fAdherence, float3 vTwitch, float4 vRoll, bool bTwitch, bool bRoll,
                  float3 vRotatedWindVector)
{
    float offset = dot(frac(30.3 * (vAnchor + fTrigOffset)), 1.0);
    float2 waves = TrigApproximate(float4(fTime + offset, 0.75 * fTime - offset, 0, 0)).xy;
    float twist = fTwist * (waves.x + waves.y * waves.y);
    float flip = fFlip * (waves.y - waves.x * waves.x);
    float jerk = bTwitch ? Twitch(vAnchor, vTwitch.x, vTwitch.y, vTwitch.z + offset) : 0.0;

    float along = clamp(dot(vRotatedWindVector, vGrowthDir), -1.0, 1.0);
    float3 axis = cross(vGrowthDir, vRotatedWindVector);
    axis.limn_ST_UP += along;
    float angle = acos(along) * fAdherence + flip + jerk;
    float3x3 turn = mul(RotationMatrix(vGrowthDir, fScale * twist),
                        RotationMatrix(limn_ST_OfLength(axis, 1.0), fScale * angle));

    float3 arm = vPos - vAnchor;
    vDirection = mul(turn, vDirection);
    return vAnchor + limn_ST_OfLength(mul(turn, arm), length(arm));
}

float3 LeafWind(bool isBestWind, bool bLeaf2, float3 vPos, inout float3 vDirection, float fScale,
                float3 vAnchor, float fPackedGrowthDir, float fPackedRippleDir,
                float fRippleTrigOffset, float3 vRotatedWindVector)
{
    float4 ripple = bLeaf2 ? _ST_WindLeaf2Ripple : _ST_WindLeaf1Ripple;
    float3 place = LeafRipple(vPos, vDirection, fScale, fPackedRippleDir, ripple.x, ripple.y, false,
                              fRippleTrigOffset);
    if (isBestWind)
    {
        float4 tumble = bLeaf2 ? _ST_WindLeaf2Tumble : _ST_WindLeaf1Tumble;
        float4 twitch = bLeaf2 ? _ST_WindLeaf2Twitch : _ST_WindLeaf1Twitch;
        place = LeafTumble(place, vDirection, fScale, vAnchor,
                           UnpackNormalFromFloat(fPackedGrowthDir), fPackedGrowthDir, tumble.x,
                           tumble.y, tumble.z, tumble.w, twitch.xyz, 0.0, true, true,
                           vRotatedWindVector);
    }
    return place;
}

// With WIND_EFFECT_FROND_RIPPLE_ADJUST_LIGHTING the normal follows, from the two that span the frond.
#ifdef WIND_EFFECT_FROND_RIPPLE_ADJUST_LIGHTING
#define limn_ST_FROND_PARAMS , float3 vBinormal, float3 vTangent
#define limn_ST_FROND_ARGS , vBinormal, vTangent
#define limn_ST_BEND(normal, by) limn_ST_BendNormal(normal, by, vBinormal, vTangent)
void limn_ST_BendNormal(inout float3 normal, float3 by, float3 binormal, float3 tangent)
{
    float3 bent = cross(binormal, normalize(tangent + by * _ST_WindFrondRipple.w));
    normal = normalize(dot(bent, normal) < 0.0 ? -bent : bent);
}
#else
#define limn_ST_FROND_PARAMS
#define limn_ST_FROND_ARGS
#define limn_ST_BEND(normal, by)
#endif

// Both halves of a frond ripple along its normal, one three quarters of a wave ahead.
float3 RippleFrondOneSided(float3 vPos, inout float3 vDirection, float fU, float fV,
                           float fRippleScale limn_ST_FROND_PARAMS)
{
    float phase = (_ST_WindFrondRipple.x + fV) * _ST_WindFrondRipple.z + (fU < 0.5 ? 0.75 : 0.0);
    float3 by = vDirection *
                (fRippleScale * _ST_WindFrondRipple.y * TrigApproximate(phase.xxxx).x);
    limn_ST_BEND(vDirection, by);
    return vPos + by;
}

float3 RippleFrondTwoSided(float3 vPos, inout float3 vDirection, float fU, float fLengthPercent,
                           float fPackedRippleDir, float fRippleScale limn_ST_FROND_PARAMS)
{
    float phase = _ST_WindFrondRipple.x * _ST_WindFrondRipple.z * fLengthPercent;
    float3 by = UnpackNormalFromFloat(fPackedRippleDir) *
                (fRippleScale * _ST_WindFrondRipple.y * TrigApproximate(phase.xxxx).x);
    limn_ST_BEND(vDirection, by);
    return vPos + by;
}

float3 RippleFrond(float3 vPos, inout float3 vDirection, float fU, float fV, float fPackedRippleDir,
                   float fRippleScale, float fLenghtPercent limn_ST_FROND_PARAMS)
{
    return RippleFrondOneSided(vPos, vDirection, fU, fV, fRippleScale limn_ST_FROND_ARGS);
}
#endif

// Passes of SpeedTree 7.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE7_PASSES_INCLUDED
#define UNIVERSAL_SPEEDTREE7_PASSES_INCLUDED
#include "SpeedTree7CommonPasses.hlsl"
#include "limn/SpeedTree7Offset.hlsl"

void InitializeData(inout SpeedTreeVertexInput input, float lodValue)
{
#ifdef ENABLE_WIND
    limn_TreeWind wind = limn_WindOfTree(_WindQuality * _WindEnabled);
#else
    limn_TreeWind wind = limn_CalmTree();
#endif
    input.vertex.xyz = limn_OffsetTree7(wind, input.vertex.xyz, input.texcoord, input.texcoord1,
                                        input.texcoord2, input.texcoord3, input.color.a, lodValue,
                                        input.normal);
}

half limn_Tree7Hue(SpeedTreeVertexInput input)
{
#ifdef EFFECT_HUE_VARIATION
    // Trees differ by where they stand, and their parts by where these lie and look.
    half ofTree = frac(dot(UNITY_MATRIX_M._14_24_34, 1.0));
    half ofPart = frac(input.normal.x + (input.normal.y + input.vertex.x));
    return saturate((ofTree + (0.5 * ofPart - 0.3)) * _HueVariation.a);
#else
    return 0;
#endif
}
// The two kinds of detail are never in one triangle.
half3 limn_Tree7Detail(SpeedTreeVertexInput input)
{
    return half3(input.texcoord2.xy, input.color.a == 0 ? input.texcoord2.z : 2.5);
}

SpeedTreeVertexOutput SpeedTree7Vert(SpeedTreeVertexInput input)
{
    SpeedTreeVertexOutput output = (SpeedTreeVertexOutput)0;
    UNITY_SETUP_INSTANCE_ID(input);
    InitializeData(input, unity_LODFade.x);
#ifdef VERTEX_COLOR
    output.color = half4(_Color.rgb * input.color.r, _Color.a); // r: ambient occlusion
#endif
    output.uvHueVariation = half3(input.texcoord.xy, limn_Tree7Hue(input));
#ifdef GEOM_TYPE_BRANCH_DETAIL
    output.detail = limn_Tree7Detail(input);
#endif
    limn_TREE_TRANSFER_LIT(input, output)
    return output;
}

SpeedTreeVertexDepthOutput SpeedTree7VertDepth(SpeedTreeVertexInput input)
{
    SpeedTreeVertexDepthOutput output = (SpeedTreeVertexDepthOutput)0;
    UNITY_SETUP_INSTANCE_ID(input);
    InitializeData(input, unity_LODFade.x);
    output.uvHueVariation.xy = input.texcoord.xy;
    limn_TREE_TRANSFER_DEPTH(input, output)
    return output;
}

SpeedTreeVertexDepthNormalOutput SpeedTree7VertDepthNormal(SpeedTreeVertexInput input)
{
    SpeedTreeVertexDepthNormalOutput output = (SpeedTreeVertexDepthNormalOutput)0;
    UNITY_SETUP_INSTANCE_ID(input);
    InitializeData(input, unity_LODFade.x);
    output.uvHueVariation.xy = input.texcoord.xy;
#ifdef GEOM_TYPE_BRANCH_DETAIL
    output.detail = limn_Tree7Detail(input);
#endif
    limn_TREE_TRANSFER_DEPTH_NORMAL(input, output)
    return output;
}
#endif

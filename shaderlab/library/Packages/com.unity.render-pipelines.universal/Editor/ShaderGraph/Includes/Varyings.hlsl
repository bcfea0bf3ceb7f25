// Between the structures of a generated shader and its entry points. The shader has defined
// Attributes, Varyings, PackedVaryings and the functions of its graph, and says by macros which
// members there are.
#pragma once

SurfaceDescription BuildSurfaceDescription(Varyings varyings)
{
    return SurfaceDescriptionFunction(BuildSurfaceDescriptionInputs(varyings));
}

#if SHADERPASS == SHADERPASS_SHADOWCASTER
float3 _LightDirection;
float3 _LightPosition;

float4 limn_ShadowPosition(float3 positionWS, float3 normalWS)
{
#if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
    float3 lightDirection = normalize(_LightPosition - positionWS);
#else
    float3 lightDirection = _LightDirection;
#endif
    return ApplyShadowClamping(
        TransformWorldToHClip(ApplyShadowBias(positionWS, normalWS, lightDirection)));
}
#endif

#if defined(FEATURES_GRAPH_VERTEX)
VertexDescription BuildVertexDescription(Attributes input)
{
    return VertexDescriptionFunction(BuildVertexDescriptionInputs(input));
}
#endif

Varyings BuildVaryings(Attributes input)
{
    Varyings output = (Varyings)0;
#if defined(FEATURES_GRAPH_VERTEX)
    // What the graph gives takes the place of what the mesh has.
    VertexDescription given = BuildVertexDescription(input);
#if defined(ATTRIBUTES_NEED_TANGENT) && defined(VARYINGS_NEED_TANGENT_WS)
    input.tangentOS.xyz = given.Tangent;
#endif
#if defined(ATTRIBUTES_NEED_NORMAL) && defined(VARYINGS_NEED_NORMAL_WS)
    input.normalOS = given.Normal;
#endif
    input.positionOS = given.Position;
#if defined(CUSTOMINTERPOLATOR_VARYPASSTHROUGH_FUNC)
    CustomInterpolatorPassThroughFunc(output, given);
#endif
#endif
    float3 normalWS = 0.0;
#if defined(ATTRIBUTES_NEED_NORMAL)
    normalWS = TransformObjectToWorldNormal(input.normalOS);
#endif
    float3 positionWS = TransformObjectToWorld(input.positionOS);
    output.positionCS = TransformWorldToHClip(positionWS);
#if SHADERPASS == SHADERPASS_SHADOWCASTER
    output.positionCS = limn_ShadowPosition(positionWS, normalWS);
#elif SHADERPASS == SHADERPASS_META
    output.positionCS = UnityMetaVertexPosition(input.positionOS, input.uv1.xy, input.uv2.xy);
#endif
#ifdef VARYINGS_NEED_POSITION_WS
    output.positionWS = positionWS;
#endif
#ifdef VARYINGS_NEED_NORMAL_WS
    output.normalWS = normalWS;
#endif
#ifdef VARYINGS_NEED_TANGENT_WS
    output.tangentWS = float4(TransformObjectToWorldDir(input.tangentOS.xyz), input.tangentOS.w);
#endif
#ifdef VARYINGS_NEED_SCREENPOSITION
    output.screenPosition = ComputeScreenPos(output.positionCS);
#endif
#ifdef VARYINGS_NEED_COLOR
    output.color = input.color;
#endif
#ifdef VARYINGS_NEED_TEXCOORD3
    output.texCoord3 = input.uv3;
#endif
#ifdef VARYINGS_NEED_TEXCOORD2
    output.texCoord2 = input.uv2;
#endif
#ifdef VARYINGS_NEED_TEXCOORD1
    output.texCoord1 = input.uv1;
#endif
#ifdef VARYINGS_NEED_TEXCOORD0
    output.texCoord0 = input.uv0;
#endif
#ifdef VARYINGS_NEED_VIEWDIRECTION_WS
    output.viewDirectionWS = GetWorldSpaceViewDir(positionWS);
#endif
#if (SHADERPASS == SHADERPASS_FORWARD || SHADERPASS == SHADERPASS_GBUFFER) && !defined(LIGHTMAP_ON)
    OUTPUT_SH(normalWS, output.sh);
#endif
#ifdef VARYINGS_NEED_FOG_AND_VERTEX_LIGHT
    output.fogFactorAndVertexLight =
        float4(ComputeFogFactor(output.positionCS.z), VertexLighting(positionWS, normalWS));
#endif
#if defined(VARYINGS_NEED_SHADOW_COORD) && defined(REQUIRES_VERTEX_SHADOW_COORD_INTERPOLATOR)
    output.shadowCoord = TransformWorldToShadowCoord(positionWS);
#endif
    return output;
}

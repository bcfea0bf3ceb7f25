// What shaders of Unity 6 declare in their materials for its view of streamed mip maps; limn streams
// none and leaves them 0.
#pragma once
#ifndef UNITY_DEBUG_MIPMAP_STREAMING_MACROS_INCLUDED
#define UNITY_DEBUG_MIPMAP_STREAMING_MACROS_INCLUDED

#define UNITY_TEXTURE_STREAMING_DEBUG_VARS_FOR_TEX(tex) float4 tex##_MipInfo; float4 tex##_StreamInfo;
#define UNITY_TEXTURE_STREAMING_DEBUG_VARS \
    float4 unity_MipmapStreaming_DebugTex_ST; \
    float4 unity_MipmapStreaming_DebugTex_TexelSize; \
    UNITY_TEXTURE_STREAMING_DEBUG_VARS_FOR_TEX(unity_MipmapStreaming_DebugTex)
#endif

// What a project may set of URP: how many lights shaders have room for at most, by platform, and
// whether fog is chosen at run time. URP 14 and later include it.
#pragma once
#ifndef SHADERCONFIG_CS_HLSL
#define SHADERCONFIG_CS_HLSL

#define MAX_VISIBLE_LIGHT_COUNT_DESKTOP (256)
#define MAX_VISIBLE_LIGHT_COUNT_MOBILE (32)
#define MAX_VISIBLE_LIGHT_COUNT_LOW_END_MOBILE (16)

#define USE_DYNAMIC_BRANCH_FOG_KEYWORD (0)
#endif

// No light has a cookie.
#pragma once
#ifndef UNIVERSAL_LIGHT_COOKIE_INPUT_INCLUDED
#define UNIVERSAL_LIGHT_COOKIE_INPUT_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/LightCookie/LightCookieTypes.hlsl"

bool IsMainLightCookieEnabled() { return false; }
bool IsLightCookieEnabled(int lightBufferIndex) { return false; }
#endif

// Old names of shadow maps' samplers; Shadows.hlsl has them.
#pragma once
#ifndef UNIVERSAL_SHADOWS_DEPRECATED_INCLUDED
#define UNIVERSAL_SHADOWS_DEPRECATED_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"
#endif

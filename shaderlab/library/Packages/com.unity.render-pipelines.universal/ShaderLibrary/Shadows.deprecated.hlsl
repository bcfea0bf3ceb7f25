// Old names of shadow maps' samplers; Shadows.hlsl has them.
#pragma once
#define UNIVERSAL_SHADOWS_DEPRECATED_INCLUDED
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

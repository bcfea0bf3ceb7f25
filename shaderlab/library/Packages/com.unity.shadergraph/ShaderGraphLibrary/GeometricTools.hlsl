// Those of the core package.
#pragma once
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/GeometricTools.hlsl"

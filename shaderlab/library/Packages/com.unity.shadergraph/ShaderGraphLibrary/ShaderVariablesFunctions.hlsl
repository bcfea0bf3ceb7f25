// Passes that graphs of URP 7 to 10 generated include this file. The pipeline's own has all of it.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

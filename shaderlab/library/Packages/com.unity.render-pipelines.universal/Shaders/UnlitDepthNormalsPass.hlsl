// Depth, and world-space normals in a colour target.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/Shaders/DepthNormalsPass.hlsl"

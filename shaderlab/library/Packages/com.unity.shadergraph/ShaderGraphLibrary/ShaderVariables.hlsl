// What generated passes of URP 7 to 10 include behind the pipeline's own files, which have all of it.
#pragma once
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

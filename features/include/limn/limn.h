#pragma once

// Everything that a program that renders with limn needs, except the device: add
// <limn/vulkan/VulkanDevice.h> to draw, <limn/core/RecordingDevice.h> to test without a GPU.
// A header that only names limn's types includes <limn/limn_fwd.h>, which costs nothing.

#include <limn/core/AsyncGPUReadback.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Debug.h>
#include <limn/core/GraphicsFormatUtility.h>
#include <limn/core/Inspector.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/QualitySettings.h>
#include <limn/core/ShaderSource.h>
#include <limn/core/UniversalFrameData.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/AllFeatures.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/features/ShippedComputeShaders.h>
#include <limn/limn_fwd.h>
#include <limn/volume/AssetParameters.h>
#include <limn/volume/CurveParameters.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/ValueParameters.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeProfileLoader.h>
#include <limn/volume/VolumeStack.h>

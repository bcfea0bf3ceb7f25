#pragma once

// Everything a program that renders with limn needs, but for the device: add
// <limn/vulkan/VulkanDevice.h> to draw, <limn/core/RecordingDevice.h> to test without a GPU.

#include <limn/core/AsyncGPUReadback.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Debug.h>
#include <limn/core/GltfMesh.h>
#include <limn/core/GraphicsFormatUtility.h>
#include <limn/core/Inspector.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/ShaderSource.h>
#include <limn/core/UniversalFrameData.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/AllFeatures.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/features/ShippedComputeShaders.h>
#include <limn/volume/AnimationCurveParameter.h>
#include <limn/volume/BoolParameter.h>
#include <limn/volume/ColorParameter.h>
#include <limn/volume/EnumParameter.h>
#include <limn/volume/FloatParameter.h>
#include <limn/volume/FloatRangeParameter.h>
#include <limn/volume/IntParameter.h>
#include <limn/volume/LayerMaskParameter.h>
#include <limn/volume/MaterialParameter.h>
#include <limn/volume/ObjectParameter.h>
#include <limn/volume/TextureCurveParameter.h>
#include <limn/volume/TextureParameter.h>
#include <limn/volume/VectorParameter.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeProfileLoader.h>
#include <limn/volume/VolumeStack.h>

#pragma once

// Everything a program that renders with limn needs, but for the device: add
// <limn/vulkan/VulkanDevice.h> to draw, <limn/core/RecordingDevice.h> to test without a GPU.

#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/GltfMesh.h>
#include <limn/core/Inspector.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/Features.h>
#include <limn/features/OutlineDrawingRenderPass.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/volume/Volume.h>
#include <limn/volume/VolumeManager.h>
#include <limn/volume/VolumeProfileLoader.h>
#include <limn/volume/VolumeStack.h>

#pragma once

#include "report/measure/StudyPicture.h"
#include "report/measure/StudyScene.h"

#include "CachedCompiler.h"

#include <gtest/gtest.h>
#include <limn/vulkan/VulkanDevice.h>

namespace limn::study
{

/// The device of the tests about precision, with validation.
inline VulkanDevice& NumericalDevice()
{
    static VulkanDevice device({"", true, {}});
    return device;
}

/// Shaders for one direction of depth; each is compiled once for all tests: scenes and techniques
/// make shaders of the same text again and again.
inline AssetContext& AssetsWithDepth(bool usesReversedZBuffer)
{
    const auto options = [](bool isReversed)
    {
        ShaderCompilerOptions result = test::CachedCompiler();
        result.usesReversedZBuffer = isReversed;
        return result;
    };
    static AssetContext reversed(options(true));
    static AssetContext standard(options(false));
    return usesReversedZBuffer ? reversed : standard;
}

} // namespace limn::study

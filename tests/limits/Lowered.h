#pragma once

#include "Paths.h"

#include <cstdlib>
#include <string>

namespace limn::test
{

/// While it lives, devices are made that have less than the driver's; see LimitsLayer.cpp.
class Lowered
{
public:
    /// @param what  "geometryShader=0,maxPerStageDescriptorSamplers=16"
    explicit Lowered(const std::string& what)
    {
        setenv("VK_ADD_LAYER_PATH", LayersFolder().c_str(), 1);
        // In this order from limn to the driver: validation sees the limits.
        setenv("VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation:VK_LAYER_LIMN_limits", 1);
        setenv("LIMN_LOWER", what.c_str(), 1);
    }
    ~Lowered()
    {
        for (const char* name : {"VK_ADD_LAYER_PATH", "VK_INSTANCE_LAYERS", "LIMN_LOWER"})
        {
            unsetenv(name);
        }
    }
    Lowered(const Lowered&) = delete;
    Lowered& operator=(const Lowered&) = delete;
};

} // namespace limn::test

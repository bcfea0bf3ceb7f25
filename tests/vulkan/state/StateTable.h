#pragma once

#include "core/scene/TestScene.h"

#include <gtest/gtest.h>
#include <map>
#include <programs/ProgramPool.h>
#include <string>
#include <vector>

namespace limn::test
{

/// A Vulkan state flattened to numbers under Vulkan's names; "front." and "back." are the stencil
/// faces, "0." … "7." the colour targets.
using VulkanValues = std::map<std::string, double>;

/// One row of a table: commands, and everything in which their state is not the default.
struct StateRow
{
    std::string commands;
    VulkanValues differences;
};

/// Eight colour targets, depth and stencil.
vulkan::TargetFormats AllTargets();

/// The same differences for every target: each name becomes eight, from "0." to "7.".
VulkanValues EveryTarget(const VulkanValues& differences);

/// The same differences for both stencil faces of a test that is on.
VulkanValues BothFaces(const VulkanValues& differences);

/// "cullMode: 2 instead of 0" a line for whatever is neither the default nor as given here.
std::string Mistakes(const VulkanValues& differences, const VulkanValues& actual);

/// `SubShader { Pass { … } }`
std::string PassWith(const std::string& commands);

/// The state of a pass of these SubShaders; the material's property _P has this value.
VulkanValues StateOf(const std::string& subShaders, float property = 0.0f, int pass = 0,
                     const vulkan::TargetFormats& formats = AllTargets());

void ExpectTable(const std::vector<StateRow>& rows);

/// `command` with each of Unity's numbers in the property [_P]; expected[i] belongs to i.
void ExpectNumbers(const std::string& command, const std::vector<VulkanValues>& expected);

} // namespace limn::test

#pragma once

#include "console/Json.h"

#include <vector>

namespace limn
{

/// Returns whether the only object of a file is a graph of Unity 2018 to 2020.1.
bool IsOldGraph(const Json& graph);

/// Returns the objects of such a graph in the form of later versions. Its master node becomes a
/// target for URP and a block for each of the node's slots.
/// @throws Json::exception if it is broken
std::vector<Json> UpgradeGraph(const Json& graph);

} // namespace limn

#pragma once

#include "library/FunctionGrid.h"

#include <vector>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{

using HlslDialectValues = GpuTest;

inline const std::vector<GridInput> k_Inputs = {
    {{1, 2, 3, 4}, {-5, 6, 7, 8}, {9, 10, -11, 12}},
    {{0.25, -2, 1e3, 0}, {1, 1, 0.5, 3}, {-1, 0, 2, -4}},
};
/// For what reads no input.
inline const std::vector<GridInput> k_Once(1);

} // namespace limn::test

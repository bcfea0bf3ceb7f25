#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limn
{

/// What a device lacks that reads no such buffers, beside the names of `#pragma require`.
inline constexpr const char* k_ScalarLayoutFeature = "scalarblocklayout";

/// The structured buffers of a program, "_Points, _Lines", whose elements lie closer together than
/// a device without scalarBlockLayout can read: as Direct3D packs them, see PackStructuredBuffers.
std::string ScalarBuffers(const std::vector<std::uint32_t>& spirv);

} // namespace limn

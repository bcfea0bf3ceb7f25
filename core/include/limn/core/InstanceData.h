#pragma once

#include <cstdint>
#include <limn/shaderlab/ShaderProgram.h>
#include <optional>
#include <span>

namespace limn
{

/// What shaders get to know of a scene's objects, by index. It stays from frame to frame, so that a
/// device copies only what has changed.
class InstanceData
{
public:
    virtual ~InstanceData() = default;

    virtual std::uint64_t id() const = 0;      ///< unique in the process
    virtual std::uint64_t version() const = 0; ///< grows with each change
    virtual std::uint32_t count() const = 0;   ///< of objects
    /// As it is now, not as it was when a frame was recorded.
    virtual PerDrawData Get(std::uint32_t object) const = 0;
    /// Objects that are not as they were at `version`, each at least once; nothing if that is too
    /// long ago to tell. Valid until the next change.
    virtual std::optional<std::span<const std::uint32_t>>
    ChangedSince(std::uint64_t version) const = 0;
};

} // namespace limn

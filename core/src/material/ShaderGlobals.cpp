#include "material/FrameGlobals.h"

#include "material/PropertyValues.h"

#include <atomic>
#include <limn/core/Shader.h>
#include <mutex>

namespace limn
{

namespace
{

struct GlobalsOfProcess
{
    std::mutex mutex;
    MaterialPropertyBlock values;
    std::atomic<std::uint64_t> version{0};
};

GlobalsOfProcess& Globals()
{
    static GlobalsOfProcess globals;
    return globals;
}

} // namespace

std::uint64_t ShaderGlobals::version()
{
    return Globals().version;
}

void ShaderGlobals::ForEach(
    const std::function<void(ShaderPropertyId, const ShaderPropertyValue&)>& function)
{
    const std::lock_guard lock(Globals().mutex);
    Globals().values.ForEach(function);
}

bool Shader::IsKeywordEnabled(std::string_view keyword)
{
    return GetGlobalInt(GlobalKeyword(keyword).id()) == 1;
}

void Shader::SetGlobal(ShaderPropertyId id, ShaderPropertyValue value)
{
    RequireFinite(value, id, "global ");
    const std::lock_guard lock(Globals().mutex);
    Globals().values.Set(id, std::move(value));
    ++Globals().version;
}

Shader::LockedValues Shader::LockedGlobals()
{
    return {std::unique_lock(Globals().mutex), Globals().values};
}

Color Shader::GetGlobalColor(ShaderPropertyId id)
{
    const glm::vec4 value = GetGlobalVector(id);
    return {value.x, value.y, value.z, value.w};
}

void Shader::SetGlobalTexture(ShaderPropertyId id, const RTHandle& value)
{
    SetGlobal(id, TextureOf(value, id, "global "));
}

} // namespace limn

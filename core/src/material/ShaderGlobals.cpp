#include "material/ShaderGlobals.h"

#include "support/RequireFinite.h"

#include <atomic>
#include <limn/core/Shader.h>
#include <map>
#include <mutex>

namespace limn
{

namespace
{

struct GlobalsOfProcess
{
    std::mutex mutex;
    std::map<ShaderPropertyId, ShaderPropertyValue> values;
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

std::optional<ShaderPropertyValue> ShaderGlobals::Find(ShaderPropertyId id)
{
    const std::lock_guard lock(Globals().mutex);
    const auto found = Globals().values.find(id);
    return found != Globals().values.end() ? std::optional(found->second) : std::nullopt;
}

void ShaderGlobals::ForEach(
    const std::function<void(ShaderPropertyId, const ShaderPropertyValue&)>& function)
{
    const std::lock_guard lock(Globals().mutex);
    for (const auto& [id, value] : Globals().values)
    {
        function(id, value);
    }
}

bool Shader::IsKeywordEnabled(std::string_view keyword)
{
    return ShaderGlobals::Find(GlobalKeyword(keyword).id()) == ShaderPropertyValue(1);
}

void Shader::SetGlobal(ShaderPropertyId id, ShaderPropertyValue value)
{
    RequireFinite(value, id, "global ");
    const std::lock_guard lock(Globals().mutex);
    Globals().values[id] = std::move(value);
    ++Globals().version;
}

void Shader::SetGlobalTexture(ShaderPropertyId id, const RTHandle& value)
{
    SetGlobal(id, TextureOf(value, id, "global "));
}

} // namespace limn

#include "plugins/NamePlugin.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/ModuleFile.h>
#include <limn/core/PluginCallSite.h>
#include <limn/vulkan/VulkanError.h>
#include <map>
#include <mutex>
#include <new>

namespace limn
{

namespace
{

/// Of the process, by where they are loaded.
struct PluginNames
{
    std::mutex mutex;
    std::map<const void*, std::string> byModule;
};

PluginNames& Names()
{
    static PluginNames names;
    return names;
}

/// "" for what is no plug-in's.
std::string PluginOf(const std::type_info& type)
{
    const std::lock_guard lock(Names().mutex);
    const auto found = Names().byModule.find(ModuleOf(&type));
    return found == Names().byModule.end() ? std::string() : found->second;
}

/// "'Red' threw in Execute of pass 'Paint'".
std::string SubjectOf(const PluginCallSite& code)
{
    const std::string name = code.name.empty() ? TypeName(code.type) : std::string(code.name);
    return code.typeOfFeature ? "'" + std::string(code.featureOfPass) + "' threw in " +
                                    code.member + " of pass '" + name + "'"
                              : "'" + name + "' threw in " + code.member;
}

/// The error, and of which plug-in's code it is, unless it names it already.
[[noreturn]] void ThrowNoted(const AssetError& error, const std::string& plugin,
                             const std::string& subject)
{
    std::vector<Diagnostic> all = error.diagnostics();
    if (std::ranges::find(all, plugin, &Diagnostic::file) != all.end())
    {
        throw;
    }
    all.push_back({Severity::Note, plugin, {}, subject + " what is said above"});
    throw AssetError(std::move(all));
}

void NamePluginOf(const PluginCallSite& code)
{
    std::string plugin = PluginOf(code.type);
    if (plugin.empty() && code.typeOfFeature)
    {
        plugin = PluginOf(*code.typeOfFeature); // whose pass is one of limn's
    }
    if (plugin.empty())
    {
        return;
    }
    try
    {
        throw;
    }
    catch (const AssetError& error)
    {
        ThrowNoted(error, plugin, SubjectOf(code));
    }
    catch (const VulkanError&)
    {
        throw;
    }
    catch (const std::bad_alloc&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        throw AssetError(plugin, {}, SubjectOf(code) + ": " + error.what());
    }
    catch (...)
    {
        throw AssetError(plugin, {}, SubjectOf(code) + ": an exception without a name");
    }
}

} // namespace

void NamePlugin(const void* symbol, const std::string& name)
{
    const std::lock_guard lock(Names().mutex);
    Names().byModule[ModuleOf(symbol)] = name;
    SetPluginCodeListener(&NamePluginOf);
}

} // namespace limn

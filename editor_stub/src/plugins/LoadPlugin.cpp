#include "plugins/LoadPlugin.h"

#include <dlfcn.h>
#include <limn/core/FeatureCode.h>
#include <limn/features/Plugin.h>
#include <limn/vulkan/VulkanError.h>
#include <map>
#include <mutex>
#include <new>

namespace limn
{

namespace
{

struct LoadedPlugin
{
    std::string name; ///< the path by which it was first asked for
    const Plugin* plugin = nullptr;
};

/// Of the process, by canonical path.
struct LoadedPlugins
{
    std::mutex mutex;
    std::map<std::string, LoadedPlugin> byPath;
};

LoadedPlugins& Loaded()
{
    static LoadedPlugins loaded;
    return loaded;
}

/// The path of the plug-in, as it was asked for, whose code defines a type; "" if none does.
std::string PluginOf(const std::type_info& type)
{
    Dl_info info{};
    if (dladdr(&type, &info) == 0 || !info.dli_fname)
    {
        return {};
    }
    const std::lock_guard lock(Loaded().mutex);
    const auto found = Loaded().byPath.find(info.dli_fname);
    return found == Loaded().byPath.end() ? std::string() : found->second.name;
}

[[noreturn]] void ThrowFor(const std::string& plugin, std::string_view name, const char* member,
                           const std::string& what)
{
    throw AssetError(
        plugin, {}, "'" + std::string(name) + "' of this plug-in threw in " + member + ": " + what);
}

/// Puts the plug-in's name to what its code threw, where the exception does not say enough itself.
void NamePlugin(const std::type_info& type, std::string_view name, const char* member)
{
    const std::string plugin = PluginOf(type);
    if (plugin.empty())
    {
        return;
    }
    try
    {
        throw;
    }
    catch (const AssetError&) // which names a file
    {
        throw;
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
        ThrowFor(plugin, name, member, error.what());
    }
    catch (...)
    {
        ThrowFor(plugin, name, member, "an exception without a name");
    }
}

/// What the loader of libraries says, without the path that it begins with.
std::string LoaderText(const std::string& path)
{
    const char* error = dlerror();
    const std::string text = error ? error : "the system does not say why";
    return text.starts_with(path + ": ") ? text.substr(path.size() + 2) : text;
}

const Plugin& Open(const std::string& canonical, const std::string& name)
{
    dlerror();
    void* library = dlopen(canonical.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!library)
    {
        throw AssetError(name, {}, "cannot be loaded as a plug-in: " + LoaderText(canonical));
    }
    const auto* plugin = static_cast<const Plugin*>(dlsym(library, "limn_plugin"));
    if (!plugin)
    {
        throw AssetError(name, {},
                         "no plug-in of limn: it has no 'limn_plugin', which LIMN_PLUGIN of "
                         "<limn/features/Plugin.h> defines");
    }
    const std::string problem = PluginProblem(*plugin);
    if (!problem.empty())
    {
        throw AssetError(name, {}, "this plug-in cannot be used: " + problem);
    }
    return *plugin;
}

const Plugin& OpenOnce(const std::string& canonical, const std::string& name)
{
    const std::lock_guard lock(Loaded().mutex);
    LoadedPlugin& loaded = Loaded().byPath[canonical];
    if (!loaded.plugin)
    {
        loaded.name = name;
        loaded.plugin = &Open(canonical, name);
        SetFeatureCodeListener(&NamePlugin);
    }
    return *loaded.plugin;
}

} // namespace

void LoadPlugin(const std::filesystem::path& path, FeatureRegistry& features,
                VolumeComponentRegistry& components)
{
    const std::string name = path.generic_string();
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::canonical(path, error);
    if (error)
    {
        throw AssetError(name, {}, "cannot be loaded as a plug-in: " + error.message());
    }
    const Plugin& plugin = OpenOnce(canonical.string(), name);
    try
    {
        AddPlugin(plugin, features, components);
    }
    catch (const ContractError& taken)
    {
        throw AssetError(name, {}, std::string("this plug-in cannot be used: ") + taken.what());
    }
}

} // namespace limn

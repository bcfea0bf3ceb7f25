#include "plugins/LoadPlugin.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/base/ModuleFile.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/vulkan/VulkanError.h>
#include <mutex>
#include <new>

namespace limn
{

namespace
{

/// The names of the process's plug-ins, by the address at which they are loaded.
struct PluginNames
{
    std::mutex mutex;
    std::map<const void*, std::string> byModule;
};

PluginNames& NamedModules()
{
    static PluginNames names;
    return names;
}

/// "" for what is no plug-in's.
std::string PluginOf(const std::type_info& type)
{
    const std::lock_guard lock(NamedModules().mutex);
    const auto found = NamedModules().byModule.find(ModuleOf(&type));
    return found == NamedModules().byModule.end() ? std::string() : found->second;
}

/// "'Red' threw in Execute of pass 'Paint'".
std::string SubjectOf(const PluginCallSite& code)
{
    const std::string name = code.name.empty() ? TypeName(code.type) : std::string(code.name);
    return code.typeOfFeature ? "'" + std::string(code.featureOfPass) + "' threw in " +
                                    code.member + " of pass '" + name + "'"
                              : "'" + name + "' threw in " + code.member;
}

std::string_view FeatureOf(const PluginCallSite& code)
{
    return code.typeOfFeature ? code.featureOfPass : code.name;
}

/// The error, and of which plug-in's code it is, unless it names it already.
[[noreturn]] void ThrowNoted(const AssetError& error, const std::string& plugin,
                             const PluginCallSite& code)
{
    std::vector<Diagnostic> all = error.diagnostics();
    if (std::ranges::find(all, plugin, &Diagnostic::file) != all.end())
    {
        throw;
    }
    all.push_back({Severity::Note, plugin, {}, SubjectOf(code) + " the error above"});
    throw PluginError(std::move(all), FeatureOf(code));
}

[[noreturn]] void ThrowNamed(const std::string& what, const std::string& plugin,
                             const PluginCallSite& code)
{
    throw PluginError({{Severity::Error, plugin, {}, SubjectOf(code) + ": " + what}},
                      FeatureOf(code));
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
        ThrowNoted(error, plugin, code);
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
        ThrowNamed(error.what(), plugin, code);
    }
    catch (...)
    {
        ThrowNamed("an exception without a name", plugin, code);
    }
}

/// From now on what the code of the module that `symbol` lies in throws, as a feature, a pass or a
/// volume component, is an AssetError that names it, but for lack of memory and failures of the
/// driver. An AssetError, which names another file, gets a note.
void NamePlugin(const void* symbol, const std::string& name)
{
    const std::lock_guard lock(NamedModules().mutex);
    NamedModules().byModule[ModuleOf(symbol)] = name;
    SetPluginCodeListener(&NamePluginOf);
}

/// The plug-ins of the process.
struct LoadedPlugins
{
    std::mutex mutex;
    std::map<std::filesystem::path, const Plugin*> byFile;        ///< canonical
    std::map<std::filesystem::path, std::string> names;           ///< what these were called
    std::map<std::filesystem::path, std::filesystem::path> files; ///< of paths that were asked for
};

LoadedPlugins& Loaded()
{
    static LoadedPlugins loaded;
    return loaded;
}

/// The file that a path leads to, or once did; the mutex is held.
std::filesystem::path FileOf(const std::filesystem::path& path)
{
    std::filesystem::path& file = Loaded().files[std::filesystem::absolute(path)];
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::canonical(path, error);
    if (!error)
    {
        file = canonical;
    }
    return file.empty() ? path : file;
}

const std::string k_RegistrationThrew = "this plug-in cannot be used: its registration threw: ";

/// AddPlugin, whose errors are the file's.
void Add(const Plugin& plugin, const Plugin* older, const std::string& name,
         FeatureRegistry& features, VolumeComponentRegistry& components)
{
    try
    {
        AddPlugin(plugin, features, components, older);
    }
    catch (const ContractError& taken)
    {
        throw AssetError(name, {}, std::string("this plug-in cannot be used: ") + taken.what());
    }
    catch (const AssetError&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        throw AssetError(name, {}, k_RegistrationThrew + error.what());
    }
    catch (...)
    {
        throw AssetError(name, {}, k_RegistrationThrew + "an exception without a name");
    }
}

/// Loads what the file holds now, and sees whether it can be registered.
const Plugin& Open(const std::filesystem::path& file, const std::string& name,
                   PluginLoading loading, const Plugin* older)
{
    const void* symbol = OpenModule(file, name, loading == PluginLoading::Copy, "limn_plugin");
    if (!symbol)
    {
        throw AssetError(name, {},
                         "the file is no plug-in of limn: it does not define 'limn_plugin'; write "
                         "LIMN_PLUGIN of <limn/features/Plugin.h> in one of its files");
    }
    const Plugin& plugin = *static_cast<const Plugin*>(symbol);
    const std::string problem = PluginProblem(plugin);
    if (!problem.empty())
    {
        throw AssetError(name, {}, "this plug-in cannot be used: " + problem);
    }
    NamePlugin(symbol, name);
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    Add(plugin, older, name, features, components);
    return plugin;
}

} // namespace

void LoadPlugin(const std::filesystem::path& path, FeatureRegistry& features,
                VolumeComponentRegistry& components, PluginLoading loading)
{
    const std::string name = path.generic_string();
    const std::lock_guard lock(Loaded().mutex);
    const std::filesystem::path file = FileOf(path);
    const Plugin*& plugin = Loaded().byFile[file];
    if (!plugin)
    {
        plugin = &Open(file, name, loading, nullptr);
        Loaded().names[file] = name;
    }
    Add(*plugin, nullptr, name, features, components);
}

void ReloadPlugin(const std::filesystem::path& path)
{
    const std::string name = path.generic_string();
    const std::lock_guard lock(Loaded().mutex);
    const std::filesystem::path file = FileOf(path);
    const Plugin*& plugin = Loaded().byFile[file];
    if (!plugin)
    {
        return;
    }
    try
    {
        plugin = &Open(file, name, PluginLoading::Copy, plugin);
    }
    catch (const AssetError& error)
    {
        std::vector<Diagnostic> all = error.diagnostics();
        all.push_back({Severity::Note, name, {}, "the plug-in loaded before stays in use"});
        throw AssetError(std::move(all));
    }
}

std::map<std::filesystem::path, std::string> EmbeddedShaderFiles()
{
    const std::lock_guard lock(Loaded().mutex);
    std::map<std::filesystem::path, std::string> files;
    for (const auto& [file, plugin] : Loaded().byFile)
    {
        if (!plugin || !plugin->shaders || !plugin->shaderFolder)
        {
            continue;
        }
        const std::filesystem::path folder = plugin->shaderFolder();
        for (const EmbeddedFile& shader : plugin->shaders())
        {
            files.emplace((folder / shader.path).lexically_normal(), Loaded().names[file]);
        }
    }
    return files;
}

} // namespace limn

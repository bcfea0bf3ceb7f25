#include "command_line/SharedFlags.h"

#include <cstdlib>

namespace limn
{

using enum Times;

Flag Argument(const char* value, const char* help, StoreValue store, Times times,
              GetCandidates candidates)
{
    return {"", value, help, std::move(store), times, std::move(candidates)};
}

GetCandidates Files(std::vector<std::string> endings)
{
    return [endings = std::move(endings)](const std::string& word)
    {
        return FileCandidates(word, endings);
    };
}

GetCandidates FilesOr(std::vector<std::string> endings, Candidates (*names)())
{
    return [endings = std::move(endings), names](const std::string& word)
    {
        Candidates all = FileCandidates(word, endings);
        const Candidates more = names();
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
}

GetCandidates Objects(const RenderOptions& scene)
{
    return [&scene](const std::string&)
    {
        return ObjectCandidates(scene);
    };
}

Flag WithLetter(char letter, Flag flag)
{
    flag.letter = letter;
    return flag;
}

Flag SceneArgument(std::string& scene)
{
    return Argument(
        "SCENE", "A *.scene.yaml, a .unity file in its project, or the folder of a Unity project",
        Into(scene), Once, Files({".scene.yaml", ".unity"}));
}

Flag Switch(const char* name, const char* help, bool& isGiven, char letter)
{
    return {name, "", help, Into(isGiven), AtMostOnce, {}, letter};
}

Flag RootFlag(std::vector<std::string>& roots)
{
    return {"root", "DIR",
            "Let references and includes lead into this folder too, not only into the file's own "
            "and the Unity project around it",
            Into(roots), Any};
}

Flag PackageFlag(std::map<std::string, std::string>& packages)
{
    return {"package", "[NAME=]DIR",
            "Take a package's shader includes from a folder of your own; without NAME its "
            "package.json names the package",
            IntoPackages(packages), AnyInARow};
}

Flag PluginFlag(std::vector<std::string>& plugins)
{
    return {"plugin",
            "FILE.so",
            "Load features, volume components and shaders from a module, whose code runs",
            Into(plugins),
            Any,
            Files({".so"})};
}

Flag SceneFlag(RenderOptions& options)
{
    return {"scene", "FILE",
            "The .unity file to draw if SCENE is the folder of a Unity project, as a path from "
            "that folder; without it the first scene of the build settings",
            Into(options.sceneInProject)};
}

Flag SizeFlag(RenderOptions& options)
{
    return {"size", "WxH",
            "The size of the picture in pixels; without it the scene's size is taken",
            IntoSize(options.width, options.height)};
}

Flag DeviceFlag(std::string& device)
{
    const char* usual = std::getenv("LIMN_DEVICE");
    device = usual ? usual : "";
    return {"device", "NAME",
            "'software', a position in `limn doctor`'s list, or a part of a name; without it the "
            "one that LIMN_DEVICE names, else the first real GPU, else the software device",
            Into(device)};
}

Flag ProfileFlag(std::string& profile)
{
    return {"profile",
            "FILE",
            "Use this volume profile in place of that of every global volume",
            Into(profile),
            AtMostOnce,
            Files({".profile.yaml", ".asset"})};
}

Flag SetFlag(RenderOptions& options)
{
    const auto candidates = [&options](const std::string& word)
    {
        return SettingCandidates(word, {options.scene, false, options.plugins, options.roots});
    };
    return {"set",
            "NAME.path=VALUE",
            "Change one value; NAME is a volume component's type, a feature's name or a feature's "
            "type",
            Into(options.overrides, CheckAssignment),
            Any,
            candidates};
}

Flag NewFolderFlag(std::string& folder)
{
    return {"output", "DIR", "A new or empty folder", Into(folder, CheckFolder), Once, {}, 'o'};
}

Flag SelectFlag(RenderOptions& options)
{
    return {"select",
            "NAME,...",
            "Select the objects of these names with their children, and no others: they "
            "get the rendering layer that outline features look for; \"\" selects nothing",
            IntoSelection(options.selection, SelectionStep::Kind::Select),
            Any,
            Objects(options)};
}

} // namespace limn

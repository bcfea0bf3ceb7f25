#include "commands/Commands.h"

#include "plugins/LoadPlugin.h"
#include "schema/Schemas.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

Json SchemaOf(const std::string& kind, std::span<const std::string> plugins)
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    for (const std::string& plugin : plugins)
    {
        LoadPlugin(plugin, features, components);
    }
    if (kind == "scene")
    {
        return SceneSchema(features);
    }
    if (kind == "material")
    {
        return MaterialFileSchema();
    }
    return ProfileSchema(components);
}

} // namespace

int RunSchema(const std::string& kind, std::span<const std::string> plugins, Console& console)
{
    console.Results(JsonText(SchemaOf(kind, plugins)));
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn

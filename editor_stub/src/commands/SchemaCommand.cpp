#include "commands/Commands.h"

#include "plugins/LoadPlugin.h"
#include "schema/Schemas.h"

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
    return kind == "scene"      ? SceneSchema(features)
           : kind == "material" ? MaterialFileSchema()
                                : ProfileSchema(components);
}

} // namespace

ExitCode RunSchema(const std::string& kind, std::span<const std::string> plugins, Console& console)
{
    console.Results(JsonText(SchemaOf(kind, plugins)));
    return ExitCode::Done;
}

} // namespace limn

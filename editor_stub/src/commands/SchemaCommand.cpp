#include "commands/Commands.h"

#include "plugins/LoadPlugin.h"
#include "schema/Schemas.h"

#include <limn/features/Features.h>

namespace limn
{

ExitCode RunSchema(const std::string& kind, std::span<const std::string> plugins, Console& console)
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    for (const std::string& plugin : plugins)
    {
        LoadPlugin(plugin, features, components);
    }
    console.Results(JsonText(kind == "scene"      ? SceneSchema(features)
                             : kind == "material" ? RootSchema("limn material", MaterialSchema())
                                                  : ProfileSchema(components)));
    return ExitCode::Done;
}

} // namespace limn

#include "commands/SchemaCommand.h"

#include "schema/Schemas.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

Json SchemaOf(const std::string& kind)
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
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

int RunSchema(const std::string& kind, Console& console)
{
    console.Results(JsonText(SchemaOf(kind)));
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn

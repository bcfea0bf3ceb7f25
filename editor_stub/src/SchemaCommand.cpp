#include "SchemaCommand.h"

#include "ProfileSchema.h"
#include "SceneSchema.h"

#include <limn/editor_stub/RunLimn.h>
#include <limn/features/Features.h>

namespace limn
{

int RunSchema(const std::string& kind, Console& console)
{
    VolumeComponentRegistry registry;
    RegisterVolumeComponents(registry);
    console.out() << (kind == "scene" ? SceneSchema() : ProfileSchema(registry)).dump(2) << '\n';
    return static_cast<int>(ExitCode::Done);
}

} // namespace limn

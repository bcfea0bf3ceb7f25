#include "Paths.h"

namespace limn::test
{

std::string SourcePath(std::string_view relative)
{
    return std::string(LIMN_SOURCE_DIR "/").append(relative);
}

std::string LimnExecutable()
{
    return LIMN_EXECUTABLE;
}

bool LimnHasSanitizers()
{
#ifdef LIMN_HAS_SANITIZERS
    return true;
#else
    return false;
#endif
}

std::string LayersFolder()
{
    return LIMN_LAYERS_FOLDER;
}

} // namespace limn::test

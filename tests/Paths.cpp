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

bool LimnCountsAllocations()
{
    return LIMN_COUNTS_ALLOCATIONS;
}

std::string LayersFolder()
{
    return LIMN_LAYERS_FOLDER;
}

} // namespace limn::test

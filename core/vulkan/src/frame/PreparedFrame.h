#pragma once

#include "descriptors/FrameDescriptors.h"
#include "frame/DynamicState.h"

namespace limn::vulkan
{

/// Instances of a draw that are drawn together.
struct PreparedRun
{
    VkDescriptorSet set = VK_NULL_HANDLE; ///< null where the program binds nothing
    InstanceRun instances;
};

/// A draw with everything looked up.
struct PreparedDraw
{
    const ProgramObjects* program = nullptr;
    VkPipeline pipeline = VK_NULL_HANDLE;
    std::size_t state = 0;            ///< of PreparedFrame::states
    const PooledMesh* mesh = nullptr; ///< null = there is none
    SubMesh indices;                  ///< of the mesh
    std::size_t firstRun = 0;         ///< of PreparedFrame::runs
    std::size_t runCount = 0;
};

struct PreparedPass
{
    std::size_t firstBarrier = 0; ///< of PreparedFrame::barriers
    std::size_t barrierCount = 0;
    std::size_t firstDraw = 0; ///< of PreparedFrame::draws; the pass's draws follow each other
    TargetFormats formats;
};

/// A frame as recording needs it: nothing of it changes any more. Kept from frame to frame for the
/// memory that its lists have.
struct PreparedFrame
{
    std::vector<PreparedPass> passes;
    std::vector<VkImageMemoryBarrier2> barriers;
    std::size_t firstFinalBarrier = 0;
    std::vector<PreparedDraw> draws;
    std::vector<PreparedRun> runs;
    std::vector<DynamicState> states; ///< of neighbours no two are equal
    bool usesReversedZBuffer = true;  ///< see ShaderCompilerOptions

    void Clear()
    {
        passes.clear();
        barriers.clear();
        draws.clear();
        runs.clear();
        states.clear();
    }
};

} // namespace limn::vulkan

#pragma once

#include "frame/DynamicState.h"
#include "frame/FrameDescriptors.h"

namespace limn::vulkan
{

/// Instances of a draw that are drawn together.
struct PreparedRun
{
    VkDescriptorSet set = VK_NULL_HANDLE; ///< null where the program binds nothing
    InstanceRun instances;
};

/// Where an indirect command has its counts.
struct PreparedArguments
{
    VkBuffer buffer = VK_NULL_HANDLE; ///< null = the command has them itself
    VkDeviceSize offset = 0;
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
    PreparedArguments arguments;
};

/// A dispatch with everything looked up.
struct PreparedDispatch
{
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE; ///< null where the kernel binds nothing
    PreparedArguments arguments;
};

struct PreparedPass
{
    std::size_t firstBarrier = 0; ///< of PreparedFrame::barriers
    std::size_t barrierCount = 0;
    std::size_t firstMemoryBarrier = 0; ///< of PreparedFrame::memoryBarriers
    std::size_t memoryBarrierCount = 0;
    std::size_t firstDispatch = 0; ///< of PreparedFrame::dispatches
    std::size_t firstDraw = 0;     ///< of PreparedFrame::draws; the pass's draws follow each other
    TargetFormats formats;
};

/// A frame as recording needs it: nothing of it changes any more. Kept from frame to frame for the
/// memory that its lists have.
struct PreparedFrame
{
    std::vector<PreparedPass> passes;
    std::vector<VkImageMemoryBarrier2> barriers;
    std::vector<VkMemoryBarrier2> memoryBarriers; ///< of buffers
    std::vector<PreparedDispatch> dispatches;
    std::size_t firstFinalBarrier = 0;
    std::vector<PreparedDraw> draws;
    std::vector<PreparedRun> runs;
    std::vector<DynamicState> states; ///< of neighbours no two are equal
    DescriptorLists descriptors;
    bool usesReversedZBuffer = true; ///< see ShaderCompilerOptions

    void Clear()
    {
        passes.clear();
        barriers.clear();
        memoryBarriers.clear();
        dispatches.clear();
        draws.clear();
        runs.clear();
        states.clear();
    }
};

} // namespace limn::vulkan

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

/// The place of the counts of an indirect command.
struct PreparedArguments
{
    VkBuffer buffer = VK_NULL_HANDLE; ///< null = the command contains the counts
    VkDeviceSize offset = 0;
};

/// A draw with all the objects that it needs.
struct PreparedDraw
{
    const ProgramObjects* program = nullptr;
    const UniquePipeline* pipeline = nullptr;
    std::size_t state = 0;            ///< index in PreparedFrame::states
    const PooledMesh* mesh = nullptr; ///< null = there is none
    SubMesh indices;                  ///< the indices of the mesh
    std::size_t firstRun = 0;         ///< index in PreparedFrame::runs
    std::size_t runCount = 0;
    PreparedArguments arguments;
};

/// A dispatch with all the objects that it needs.
struct PreparedDispatch
{
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE; ///< null where the kernel binds nothing
    PreparedArguments arguments;
};

struct PreparedPass
{
    std::size_t firstBarrier = 0; ///< index in PreparedFrame::barriers
    std::size_t barrierCount = 0;
    std::size_t firstMemoryBarrier = 0; ///< index in PreparedFrame::memoryBarriers
    std::size_t memoryBarrierCount = 0;
    std::size_t firstDispatch = 0; ///< index in PreparedFrame::dispatches
    std::size_t firstDraw = 0; ///< index in PreparedFrame::draws; the pass's draws are consecutive
    TargetFormats formats;
};

/// A frame in the form that recording needs; recording does not change it. It is kept from frame to
/// frame, so that its lists keep their memory.
struct PreparedFrame
{
    std::vector<PreparedPass> passes;
    std::vector<VkImageMemoryBarrier2> barriers;
    std::vector<VkMemoryBarrier2> memoryBarriers; ///< the barriers of buffers
    std::vector<PreparedDispatch> dispatches;
    std::size_t firstFinalBarrier = 0;
    std::vector<PreparedDraw> draws;
    std::vector<PreparedRun> runs;
    std::vector<DynamicState> states; ///< no two consecutive ones are equal
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

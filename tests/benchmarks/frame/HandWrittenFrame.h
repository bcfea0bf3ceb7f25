#pragma once

#include "descriptors/DescriptorCache.h"
#include "device/VulkanContext.h"
#include "frame/HandWrittenScene.h"
#include "memory/MemoryAllocator.h"
#include "resources/SamplerCache.h"
#include <functional>
#include <limn/core/Image.h>
#include <map>

namespace limn::benchmarks
{

/// The article's frame as somebody writes it who wants nothing but this frame, in plain Vulkan:
/// pipelines without dynamic state, descriptor sets written once, all meshes in one buffer, the
/// exact barriers, the outline's mask and edges before the lit objects so that the composite is in
/// their pass. Two frames in flight, each with commands that are kept as long as the same objects
/// are in sight. Only what is not the frame itself (device, memory, samplers) is limn's.
class HandWrittenFrame
{
public:
    explicit HandWrittenFrame(const ArticleNumbers& numbers, const std::string& device);
    ~HandWrittenFrame();
    HandWrittenFrame(const HandWrittenFrame&) = delete;
    HandWrittenFrame& operator=(const HandWrittenFrame&) = delete;

    void Move(Movement what, int step) { m_Scene.Move(what, step); }
    void Draw();                       ///< decides on all objects, writes what changed and submits
    void Wait();                       ///< until all frames are done
    double DeviceMilliseconds() const; ///< the passes of the last frame. @pre it is done
    Image ReadBack();                  ///< the output of the last frame
    std::size_t drawCount() const;

private:
    struct Target
    {
        vulkan::MemoryAllocation memory;
        vulkan::UniqueImage image;
        vulkan::UniqueImageView view;
        VkFormat format = VK_FORMAT_UNDEFINED;
        VkExtent2D extent{};
    };

    struct Stage
    {
        std::shared_ptr<const ShaderProgram> program;
        vulkan::UniqueSetLayout setLayout;
        vulkan::UniquePipelineLayout layout;
        vulkan::UniquePipeline pipeline;
    };

    /// One frame in flight.
    struct Slot
    {
        vulkan::UniqueCommandPool pool;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        vulkan::UniqueQueryPool queries;
        vulkan::Buffer data; ///< uniforms, then objects
        vulkan::DescriptorAllocator descriptors;
        std::vector<VkDescriptorSet> materials;
        VkDescriptorSet mask = VK_NULL_HANDLE;
        VkDescriptorSet edge = VK_NULL_HANDLE;
        VkDescriptorSet composite = VK_NULL_HANDLE;
        VkDescriptorSet final = VK_NULL_HANDLE;
        std::uint64_t number = 0;         ///< of its last frame
        std::uint64_t version = 0;        ///< of the scene then
        std::vector<ArticleGroup> groups; ///< that its commands draw

        explicit Slot(VkDevice device) : descriptors(device) {}
    };

    struct PlacedMesh
    {
        std::int32_t vertex = 0; ///< its first one
        std::uint32_t index = 0; ///< likewise
        std::uint32_t indexCount = 0;
    };

    void CreateTargets();
    Target CreateTarget(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage);
    void CreateStages();
    Stage CreateStage(const std::shared_ptr<const ShaderProgram>& program, const Target& target,
                      VkFormat depth, bool blends);
    void CreateMeshes();
    void CreateSlot(Slot& slot);
    VkDescriptorSet CreateSet(Slot& slot, const Stage& stage, const DrawBindings& bindings);
    VkImageView ViewOf(const Texture& texture);
    void UploadTexels(const TexelTexture& texture, Target& target);
    VkCommandBuffer CreateCommands(vulkan::UniqueCommandPool& pool) const;
    /// Records, submits and waits.
    void RunNow(const std::function<void(VkCommandBuffer)>& record) const;

    void WriteData(Slot& slot);
    void Record(const Slot& slot);
    void RecordMask(const Slot& slot) const;
    void RecordEdge(const Slot& slot) const;
    void RecordObjects(const Slot& slot) const;
    void RecordFinal(const Slot& slot) const;
    void BindMeshes(VkCommandBuffer commands, const Stage& stage) const;
    void DrawMesh(VkCommandBuffer commands, const ArticleGroup& group, std::uint32_t count) const;
    void WaitFor(std::uint64_t number) const;

    ArticleNumbers m_Numbers;
    HandWrittenScene m_Scene;
    vulkan::VulkanContext m_Context;
    vulkan::MemoryAllocator m_Allocator;
    vulkan::SamplerCache m_Samplers;
    Target m_Mask, m_Edge, m_Color, m_Depth, m_Output;
    std::map<std::uint64_t, Target> m_Textures; ///< by Texture::id
    Stage m_MaskStage, m_EdgeStage, m_LitStage, m_CompositeStage, m_FinalStage;
    vulkan::Buffer m_Meshes;
    std::vector<VkDeviceSize> m_Arrays; ///< of m_Meshes, by VertexAttributes()
    VkDeviceSize m_Indices = 0;
    std::map<std::uint64_t, PlacedMesh> m_PlacedMeshes; ///< by Mesh::id
    std::vector<Slot> m_Slots;
    vulkan::UniqueSemaphore m_Timeline;
    std::uint64_t m_Submitted = 0;
};

VkDescriptorType DescriptorTypeOf(const TextureBinding& texture);
/// Of the objects in Slot::data.
std::size_t ObjectsOffset(const ArticleNumbers& numbers);
/// And of the instances, which are the objects in their order.
std::size_t InstancesOffset(const ArticleNumbers& numbers);

} // namespace limn::benchmarks

#pragma once

#include <limn/core/List.h>
#include <limn/core/Mathf.h>
#include <limn/core/Random.h>
#include <limn/core/SystemInfo.h>
#include <limn/limn.h>
#include <stdexcept>

namespace limn::test
{

/// One line or more of C++ for each row of the porting table that says "same": what a line of C#
/// is when nothing but the spelling of the languages is changed. Nothing is ever called; that all
/// compiles is one half of the test, SameTest.cpp, which finds each row's line, the other.
class SameLines
{
public:
    SameLines() = delete;
    void Commands();
    void Enums();
    void Frame();
    void Materials();

private:
    struct PassData
    {
        TextureHandle source;
    };
    struct Settings
    {
        std::shared_ptr<Material> material;
    };

    CommandBuffer& cmd;
    RasterCommandBuffer& rasterCmd;
    UnsafeCommandBuffer& unsafeCmd;
    ComputeCommandBuffer& computeCmd;
    CommandBufferPool::Pooled& pooled;
    RasterGraphContext& rasterContext;
    UnsafeGraphContext& unsafeContext;
    ComputeGraphContext& computeContext;
    ScriptableRenderContext& context;
    RenderingData& renderingData;
    CameraData& cameraData;
    Camera& camera;
    UniversalCameraData& universalCameraData;
    UniversalRenderingData& universalRenderingData;
    UniversalLightData& universalLightData;
    UniversalShadowData& universalShadowData;
    UniversalResourceData& resourceData;
    ContextContainer& frameData;
    RenderGraph& renderGraph;
    RasterRenderGraphBuilder<PassData>& rasterBuilder;
    UnsafeRenderGraphBuilder<PassData>& unsafeBuilder;
    ComputeRenderGraphBuilder<PassData>& computeBuilder;
    PassData*& passData;
    TextureHandle& textureHandle;
    BufferHandle& bufferHandle;
    RendererListHandle& listHandle;
    TextureDesc& textureDesc;
    BufferDesc& bufferDesc;
    ImportResourceParams& importParams;
    RendererListParams& listParams;
    RendererListDesc& listDesc;
    RendererList& list;
    DrawingSettings& drawing;
    FilteringSettings& filtering;
    SortingSettings& sorting;
    RenderStateBlock& stateBlock;
    StencilState& stencil;
    ScriptableRenderPass& pass;
    ScriptableRendererFeature& feature;
    ProfilingSampler& sampler;
    RenderTextureDescriptor& descriptor;
    RenderTargetIdentifier& identifier;
    RenderTargetHandle& handle;
    RTHandle& a;
    RTHandle& b;
    Settings& settings;
    std::shared_ptr<Material>& material;
    std::shared_ptr<const Shader>& shader;
    std::shared_ptr<const Mesh>& mesh;
    std::shared_ptr<ComputeShader>& compute;
    std::shared_ptr<GraphicsBuffer>& buffer;
    std::shared_ptr<ComputeBuffer>& computeBuffer;
    MaterialPropertyBlock& block;
    MeshRenderer& renderer;
    AsyncGPUReadbackRequest& request;
    GlobalKeyword& globalKeyword;
    LocalKeyword& localKeyword;
    ShaderTagId& tag;
    ShaderPropertyId& id;
    glm::mat4& matrix;
    std::vector<glm::mat4>& matrices;
    std::vector<glm::vec4>& vectors;
    std::vector<float>& floats;
    std::vector<int>& ints;
    std::vector<int>& subMeshes;
    std::vector<Color>& colors;
    std::vector<ShaderTagId>& tags;
    std::vector<std::shared_ptr<const Mesh>>& meshes;
    std::vector<std::shared_ptr<const Material>>& constMaterials;
    std::vector<RenderBufferStoreAction>& storeActions;
    List<float>& numbers;
    std::uint32_t& size;
    float& number;
    GraphicsFormat& format;
    Color& color;
    Color32& color32;
    VolumeManager& volumes;
    VolumeStack& stack;
    Volume& volume;
    VolumeComponent& component;
    FloatParameter& parameter;
    Bloom& bloom;
};

} // namespace limn::test

/// @param ...  an expression
#define SAME(key, ...) static_cast<void>((__VA_ARGS__))

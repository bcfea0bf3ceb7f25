#include "port/Differs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>

namespace limn::test
{

namespace
{

constexpr GraphicsFormat k_Format = GraphicsFormat::R8G8B8A8_UNorm;

template <typename Change>
void ExpectNoTextureOf(Change change)
{
    RenderTextureDescriptor descriptor(8, 4, k_Format);
    EXPECT_NO_THROW(RenderTexture("T", descriptor));
    change(descriptor);
    EXPECT_THROW(RenderTexture("T", descriptor), ContractError);
}

void ExpectFlatTargetsOnly()
{
    using Descriptor = RenderTextureDescriptor;
    ExpectNoTextureOf([](Descriptor& d) { d.bindMS = true; });
    ExpectNoTextureOf([](Descriptor& d) { d.dimension = TextureDimension::Cube; });
    ExpectNoTextureOf([](Descriptor& d) { d.volumeDepth = 2; });
    ExpectNoTextureOf([](Descriptor& d) { d.vrUsage = VRTextureUsage::TwoEyes; });
    const auto expectRefused = [](auto change)
    {
        TextureDesc desc(8, 4);
        EXPECT_NO_THROW(RenderTexture("T", desc.descriptor()));
        change(desc);
        EXPECT_THROW(RenderTexture("T", desc.descriptor()), ContractError);
    };
    expectRefused([](TextureDesc& d) { d.bindTextureMS = true; });
    expectRefused([](TextureDesc& d) { d.dimension = TextureDimension::Tex3D; });
    expectRefused([](TextureDesc& d) { d.slices = 2; });
}

void ExpectFormatsByFunctions()
{
    RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8G8B8A8_SRGB);
    EXPECT_TRUE(descriptor.sRGB());
    descriptor.SetColorFormat(RenderTextureFormat::R8);
    EXPECT_EQ(descriptor.graphicsFormat, GraphicsFormat::R8_UNorm);
    EXPECT_FALSE(descriptor.sRGB());
    EXPECT_EQ(descriptor.depthStencilFormat(), GraphicsFormat::None);
    descriptor.SetDepthStencilFormat(GraphicsFormat::D32_SFloat);
    EXPECT_EQ(descriptor.depthStencilFormat(), GraphicsFormat::D32_SFloat);
    descriptor.SetDepthStencilFormat(GraphicsFormat::None);
    EXPECT_EQ(descriptor.depthBufferBits, 0);
}

void ExpectFunctionsOfAHandle()
{
    RenderTextureDescriptor descriptor(8, 4, k_Format);
    descriptor.msaaSamples = 4;
    descriptor.useMipMap = false;
    RTHandle handle = RTHandles::Alloc(descriptor, FilterMode::Point, TextureWrapMode::Clamp, "H");
    EXPECT_EQ(handle.rt()->name(), "H");
    EXPECT_EQ(handle.rt()->descriptor().width, 8);
    EXPECT_FALSE(handle.rt()->descriptor().useMipMap);
    EXPECT_EQ(handle.nameID(), RenderTargetIdentifier(std::shared_ptr<const Texture>(handle.rt())));
    EXPECT_TRUE(handle.isMSAAEnabled());
    EXPECT_FALSE(handle.useScaling());
    EXPECT_EQ(RTHandles::rtHandleProperties().rtHandleScale, glm::vec4(1));
    EXPECT_EQ(handle.rtHandleProperties().rtHandleScale, glm::vec4(1));
    const std::weak_ptr<const RenderTexture> texture = handle.rt();
    handle = RTHandle(); // what a destructor does
    EXPECT_TRUE(texture.expired());
}

void ExpectScalesOfAHandle()
{
    RTHandles::SetReferenceSize(16, 8);
    EXPECT_EQ(RTHandles::maxWidth(), 16);
    EXPECT_EQ(RTHandles::maxHeight(), 8);
    const RTHandle half = RTHandles::Alloc(glm::vec2(0.5f), {1, 1, k_Format});
    EXPECT_TRUE(half.useScaling());
    EXPECT_EQ(half.scaleFactor(), glm::vec2(0.5f));
    EXPECT_EQ(half.rt()->width(), 8);
    const RTHandle less = RTHandles::Alloc(
        [](const glm::ivec2& size) { return glm::ivec2(size.x - 1, size.y); }, {1, 1, k_Format});
    EXPECT_EQ(less.rt()->width(), 15) << "the function is said when it is allocated";
}

void ExpectReAllocationByNamedArguments()
{
    RTHandle handle;
    const RenderTextureDescriptor descriptor(8, 4, GraphicsFormat::R8_UNorm);
    const auto ask = [&]
    {
        return RenderingUtils::ReAllocateIfNeeded(
            handle, descriptor, {.wrapMode = TextureWrapMode::Clamp, .name = "_Mask"});
    };
    EXPECT_TRUE(ask());
    EXPECT_FALSE(ask());
    EXPECT_EQ(handle.rt()->name(), "_Mask");
    EXPECT_EQ(handle.rt()->sampler().filterMode, FilterMode::Point);
    EXPECT_EQ(handle.rt()->sampler().wrapModeU, TextureWrapMode::Clamp);
    EXPECT_FALSE(RenderingUtils::ReAllocateHandleIfNeeded(
        handle, descriptor, FilterMode::Point, TextureWrapMode::Clamp, 1, 0.0f, "_Mask"));
    EXPECT_TRUE(RenderingUtils::ReAllocateHandleIfNeeded(handle, descriptor, {.name = "_Mask"}));
}

void ExpectAlwaysTheSameFullscreenMesh()
{
    EXPECT_EQ(RenderingUtils::fullscreenMesh(), RenderingUtils::fullscreenMesh());
    EXPECT_EQ(RenderingUtils::fullscreenMesh()->data().vertices.size(), 4u);
}

void ExpectCubesByName()
{
    for (const char* name : {"black", "white"})
    {
        const auto cube = DefaultTexture(name, TextureDimension::Cube);
        EXPECT_EQ(cube->dimension(), TextureDimension::Cube);
        EXPECT_EQ(cube->name(), name);
    }
}

void ExpectEngineMaterialsToHaveAShader()
{
    EXPECT_NE(CoreUtils::CreateEngineMaterial(DiffersShader()), nullptr);
    EXPECT_THROW(CoreUtils::CreateEngineMaterial(std::shared_ptr<const Shader>()), ContractError);
}

void ExpectDestroyToLetGo()
{
    auto material = std::make_shared<Material>(DiffersShader());
    const std::weak_ptr<Material> seen = material;
    CoreUtils::Destroy(material);
    EXPECT_EQ(material, nullptr);
    EXPECT_TRUE(seen.expired());
}

void ExpectFunctionsOfABuffer()
{
    using Target = GraphicsBuffer::Target;
    GraphicsBuffer buffer(Target::Structured, 4, 8);
    EXPECT_EQ(buffer.count(), 4);
    EXPECT_EQ(buffer.stride(), 8);
    EXPECT_EQ(buffer.target(), Target::Structured);
    buffer.SetName("Edges");
    EXPECT_EQ(buffer.name(), "Edges");
}

void ExpectDepthsOfThirtyTwoBits()
{
    using enum GraphicsFormat;
    for (const auto& [asked, made] :
         {std::pair(D16_UNorm, D32_SFloat), std::pair(D24_UNorm, D32_SFloat),
          std::pair(D24_UNorm_S8_UInt, D32_SFloat_S8_UInt),
          std::pair(D16_UNorm_S8_UInt, D32_SFloat_S8_UInt), std::pair(S8_UInt, D32_SFloat_S8_UInt)})
    {
        const RenderTexture texture("Depth", RenderTextureDescriptor(8, 4, asked));
        EXPECT_EQ(texture.graphicsFormat(), made) << ToString(asked);
        RenderTextureDescriptor descriptor(8, 4, None);
        descriptor.SetDepthStencilFormat(asked);
        EXPECT_EQ(RenderTexture("Depth", descriptor).graphicsFormat(), made) << ToString(asked);
    }
    EXPECT_EQ(GraphicsFormatUtility::GetDepthStencilFormat(16, 0), D32_SFloat);
    EXPECT_EQ(GraphicsFormatUtility::GetDepthStencilFormat(24, 8), D32_SFloat_S8_UInt);
    EXPECT_EQ(GraphicsFormatUtility::GetDepthStencilFormat(32), D32_SFloat_S8_UInt);
    EXPECT_EQ(GraphicsFormatUtility::GetDepthStencilFormat(0, 0), None);
}

} // namespace

DiffersChecks TargetDiffers()
{
    std::vector<std::string> flat =
        Members("RenderTextureDescriptor", {"bindMS", "dimension", "volumeDepth", "vrUsage"});
    const auto descs = Members("TextureDesc", {"bindTextureMS", "dimension", "slices"});
    flat.insert(flat.end(), descs.begin(), descs.end());
    return {{flat, ExpectFlatTargetsOnly},
            {Members("RenderTextureDescriptor", {"colorFormat", "depthStencilFormat", "sRGB"}),
             ExpectFormatsByFunctions},
            {Members("RTHandle",
                     {"rt", "nameID", "name", "isMSAAEnabled", "rtHandleProperties", "Release"}),
             ExpectFunctionsOfAHandle},
            {{"RTHandle.useScaling", "RTHandle.scaleFactor", "RTHandle.scaleFunc",
              "RTHandle.referenceSize", "RTHandles.maxWidth", "RTHandles.maxHeight",
              "RTHandles.rtHandleProperties"},
             ExpectScalesOfAHandle},
            {Members("RenderingUtils", {"ReAllocateIfNeeded", "ReAllocateHandleIfNeeded"}),
             ExpectReAllocationByNamedArguments},
            {{"RenderingUtils.fullscreenMesh"}, ExpectAlwaysTheSameFullscreenMesh},
            {Members("CoreUtils", {"blackCubeTexture", "whiteCubeTexture"}), ExpectCubesByName},
            {{"CoreUtils.CreateEngineMaterial"}, ExpectEngineMaterialsToHaveAShader},
            {{"CoreUtils.Destroy"}, ExpectDestroyToLetGo},
            {Members("GraphicsBuffer", {"count", "stride", "target", "name"}),
             ExpectFunctionsOfABuffer},
            {{"GraphicsFormat.D16_UNorm", "GraphicsFormat.D24_UNorm",
              "GraphicsFormat.D24_UNorm_S8_UInt", "GraphicsFormat.S8_UInt",
              "GraphicsFormat.D16_UNorm_S8_UInt", "GraphicsFormatUtility.GetDepthStencilFormat"},
             ExpectDepthsOfThirtyTwoBits}};
}

} // namespace limn::test

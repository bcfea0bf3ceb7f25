#pragma once

#include "CachedCompiler.h"
#include "features/OutlineGpuReference.h"
#include "vulkan/GpuTestDevice.h"

#include <cstdlib>
#include <filesystem>
#include <limn/base/ReadFile.h>
#include <limn/core/OutlineNormals.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/features/Features.h>
#include <limn/features/RenderObjects.h>
#include <map>

namespace limn::test
{

inline constexpr int k_BodyLayer = 6;

inline std::shared_ptr<ShaderCompiler> EffectCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>(CachedCompiler());
    return compiler;
}

/// The two shaders that an object of the effect is drawn with.
struct EffectShaders
{
    std::shared_ptr<const Shader> outline;
    std::shared_ptr<const Shader> solid;
};

inline EffectShaders LimnEffectShaders(const char* outline = "Limn/TranslucentOutline")
{
    static std::map<std::string, std::shared_ptr<const Shader>> shaders;
    for (const char* name : {outline, "Limn/TranslucentSolid"})
    {
        std::shared_ptr<const Shader>& shader = shaders[name];
        shader = shader ? shader : FindShippedShader(name, EffectCompiler());
    }
    return {shaders[outline], shaders["Limn/TranslucentSolid"]};
}

/// The article's own files but for a sign; null where LIMN_CORPUS_DIR does not lead to them.
inline EffectShaders ArticleShaders()
{
    const char* corpus = std::getenv("LIMN_CORPUS_DIR");
    const std::filesystem::path folder(corpus != nullptr ? corpus : "");
    const std::filesystem::path outline = folder / "s1_GWMUnlitOutline.shader";
    if (!std::filesystem::exists(outline))
    {
        return {};
    }
    // It takes the projection's vertical scale for positive, which Unity has negative in a texture.
    std::string text = ReadFile(outline);
    constexpr std::string_view k_Scale = "UNITY_MATRIX_P._m11";
    for (std::size_t at = text.find(k_Scale); at != text.npos; at = text.find(k_Scale, at + 25))
    {
        text.replace(at, k_Scale.size(), "abs(" + std::string(k_Scale) + ")");
    }
    return {Shader::FromText(text, outline.string(), EffectCompiler()),
            Shader::Load(folder / "s1_GWMUnlitTransparentOutline.shader", EffectCompiler())};
}

/// What a frame left: the camera's linear colour and the stencil (one byte a pixel; empty where the
/// frame had none).
struct EffectPicture
{
    Field color;
    Image stencil;

    int StencilAt(int x, int y) const
    {
        return std::to_integer<int>(
            stencil.texels.at(static_cast<std::size_t>(y * color.width + x)));
    }
};

/// A scene whose layer 6 goes through the effect: a RenderObjects feature draws the StencilMask
/// passes before the transparent objects.
class TranslucentScene
{
public:
    explicit TranslucentScene(const EffectShaders& shaders)
        : outline(std::make_shared<Material>(shaders.outline)),
          solid(std::make_shared<Material>(shaders.solid))
    {
        camera.clearFlags = CameraClearFlags::SolidColor;
        camera.backgroundColor = {0.0f, 0.0f, 0.0f, 0.0f};
        RenderObjectsSettings settings;
        settings.filterSettings.RenderQueueType = RenderQueueType::Transparent;
        settings.filterSettings.LayerMask = LayerMask::FromIndex(k_BodyLayer);
        settings.filterSettings.PassNames = {"StencilMask"};
        renderer.AddFeature(std::make_unique<RenderObjects>(settings));
    }

    GameObject& AddBody(std::shared_ptr<const Mesh> mesh, const glm::vec3& position)
    {
        GameObject& object = Add(std::move(mesh), position, {outline, solid});
        object.layer = k_BodyLayer;
        return object;
    }

    GameObject& Add(std::shared_ptr<const Mesh> mesh, const glm::vec3& position,
                    std::vector<std::shared_ptr<const Material>> materials)
    {
        GameObject& object = scene.Add("object " + std::to_string(scene.objects().size()));
        object.transform.localPosition = position;
        MeshRenderer meshRenderer;
        meshRenderer.mesh = std::move(mesh);
        meshRenderer.sharedMaterials = std::move(materials);
        object.renderer = std::move(meshRenderer);
        return object;
    }

    EffectPicture Draw(int width, int height)
    {
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = width;
        request.height = height;
        // The camera's textures are known after a frame only; the next one keeps them readable.
        const RenderResult first = m_Pipeline.RenderSingleCamera(renderer, request);
        for (const CompiledRenderPass& pass : first.frame->passes)
        {
            if (pass.colors.front().texture->name() == "_CameraColorAttachmentA")
            {
                request.alsoReadBack = {RTHandle(pass.colors.front().texture),
                                        RTHandle(pass.depth->texture)};
            }
        }
        m_Pipeline.RenderSingleCamera(renderer, request);
        EffectPicture picture;
        picture.color = ToField(SharedDevice().ReadBack(*request.alsoReadBack.at(0).rt()));
        if (HasStencil(request.alsoReadBack.at(1).rt()->graphicsFormat()))
        {
            picture.stencil = SharedDevice().ReadBackStencil(*request.alsoReadBack.at(1).rt());
        }
        return picture;
    }

    Scene scene;
    Camera camera;
    UniversalRenderer renderer{EffectCompiler()};
    std::shared_ptr<Material> outline;
    std::shared_ptr<Material> solid;

private:
    UniversalRenderPipeline m_Pipeline{SharedDevice()};
};

/// A Unity material unlit shader, drawn over what is behind it with this opacity.
inline std::shared_ptr<Material> TranslucentUnlit(const Color& color)
{
    auto material = std::make_shared<Material>(
        FindShippedShader("Universal Render Pipeline/Unlit", EffectCompiler()));
    material->SetColor(ShaderPropertyId("_BaseColor"), color);
    material->SetFloat(ShaderPropertyId("_Surface"), 1);
    material->SetFloat(ShaderPropertyId("_SrcBlend"), 5);
    material->SetFloat(ShaderPropertyId("_DstBlend"), 10);
    material->SetFloat(ShaderPropertyId("_SrcBlendAlpha"), 5);
    material->SetFloat(ShaderPropertyId("_DstBlendAlpha"), 10);
    material->SetFloat(ShaderPropertyId("_ZWrite"), 0);
    material->SetRenderQueue(3000);
    return material;
}

} // namespace limn::test

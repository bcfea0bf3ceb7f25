#include "FullScreenRenderPass.h"

#include <limn/core/Inspector.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/FullScreenPassRendererFeature.h>

namespace limn
{

namespace
{

constexpr EnumEntry k_InjectionPoints[] = {{"BeforeRenderingTransparents", 450},
                                           {"BeforeRenderingPostProcessing", 550},
                                           {"AfterRenderingPostProcessing", 600}};
constexpr EnumEntry k_Requirements[] = {{"None", 0},  {"Depth", 1},  {"Normal", 2},
                                        {"Color", 4}, {"Motion", 8}, {"Everything", 15}};

} // namespace

FullScreenPassRendererFeature::FullScreenPassRendererFeature()
{
    name = "FullScreenPassRendererFeature";
}

FullScreenPassRendererFeature::~FullScreenPassRendererFeature() = default;

void FullScreenPassRendererFeature::Describe(Inspector& inspector)
{
    inspector.Field("injectionPoint", injectionPoint, k_InjectionPoints,
                    "The event of the frame at which the pass is drawn");
    inspector.Field("fetchColorBuffer", fetchColorBuffer,
                    "Lets the shader read the picture so far as _BlitTexture");
    inspector.Field("requirements", requirements, k_Requirements,
                    "The other textures of the camera that the shader reads");
    inspector.Field("passMaterial", passMaterial,
                    "The material that is drawn over the whole picture");
    inspector.Field("passIndex", passIndex, ValueRange{0, 255},
                    "The index of the material's pass, from 0");
    inspector.Field("bindDepthStencilAttachment", bindDepthStencilAttachment,
                    "Lets the pass test the camera's depth and stencil");
}

void FullScreenPassRendererFeature::Create()
{
    m_FullScreenPass = std::make_unique<FullScreenRenderPass>(name);
}

void FullScreenPassRendererFeature::AddRenderPasses(ScriptableRenderer& renderer,
                                                    RenderingData& renderingData)
{
    std::vector<std::string>& notes = renderingData.report->notes;
    if (!passMaterial)
    {
        notes.push_back(name + ": it is not drawn; passMaterial is not assigned");
        return;
    }
    if (passIndex < 0 || passIndex >= passMaterial->passCount())
    {
        notes.push_back(name + ": it is not drawn; passIndex is " + std::to_string(passIndex) +
                        ", but the material '" + passMaterial->name() + "' has the passes 0..." +
                        std::to_string(passMaterial->passCount() - 1));
        return;
    }
    m_FullScreenPass->renderPassEvent =
        static_cast<RenderPassEvent>(static_cast<int>(injectionPoint));
    m_FullScreenPass->SetupMembers(passMaterial, passIndex, fetchColorBuffer,
                                   bindDepthStencilAttachment, requirements);
    renderer.EnqueuePass(*m_FullScreenPass);
}

} // namespace limn

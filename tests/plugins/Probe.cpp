#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/DrawError.h>
#include <limn/core/Inspector.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/volume/FloatParameter.h>
#include <limn/volume/VolumeStack.h>

// A plug-in of the tests: it paints the picture red, or throws where its setting says.

namespace probe
{

using namespace limn;

class Probe final : public VolumeComponent
{
public:
    ClampedFloatParameter strength{this, "strength", 0.25f,
                                   0.0f, 1.0f,       {.tooltip = "How red the picture gets."}};
};

enum class Fault
{
    None,
    Create,
    AddRenderPasses,
    Setup,
    Execute,
    Nameless,
    Draw
};

constexpr EnumEntry k_Faults[] = {{"None", 0},  {"Create", 1},  {"AddRenderPasses", 2},
                                  {"Setup", 3}, {"Execute", 4}, {"Nameless", 5},
                                  {"Draw", 6}};

class ProbePass final : public ScriptableRenderPass
{
public:
    ProbePass(Fault fault, std::shared_ptr<const Shader> shader)
        : m_Fault(fault), m_Material(CoreUtils::CreateEngineMaterial(std::move(shader)))
    {
        profilingSampler = ProfilingSampler("Paint");
        renderPassEvent = RenderPassEvent::AfterRenderingTransparents;
    }

    float strength = 0.0f;

    void OnCameraSetup(CommandBuffer&, RenderingData&) override
    {
        if (m_Fault == Fault::Setup)
        {
            throw std::out_of_range("no such texture");
        }
    }

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
    {
        switch (m_Fault)
        {
        case Fault::Execute:
            throw std::runtime_error("the brush is gone");
        case Fault::Nameless:
            throw 42;
        case Fault::Draw:
            throw DrawError("a target is missing");
        default:
            break;
        }
        const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
        const RTHandle& color = renderingData.cameraData.renderer->cameraColorTargetHandle();
        m_Material->SetFloat(ShaderPropertyId("_Strength"), strength);
        CoreUtils::SetRenderTarget(*cmd, color);
        cmd->DrawProcedural(glm::mat4(1.0f), m_Material, 0, 3, {});
        context.ExecuteCommandBuffer(*cmd);
    }

private:
    Fault m_Fault;
    std::shared_ptr<Material> m_Material;
};

class ProbeFeature final : public ScriptableRendererFeature
{
public:
    Fault fault = Fault::None;

    void Create() override
    {
        if (fault == Fault::Create)
        {
            throw std::runtime_error("out of paint");
        }
        m_Pass.reset();
    }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        if (fault == Fault::AddRenderPasses)
        {
            throw std::logic_error("not today");
        }
        if (!m_Pass)
        {
            m_Pass = std::make_unique<ProbePass>(
                fault, FindShippedShader("Hidden/Probe", renderer.shaderCompiler()));
        }
        m_Pass->strength = renderingData.volumeStack->GetComponent<Probe>()->strength.value();
        renderer.EnqueuePass(*m_Pass);
    }

    void Describe(Inspector& inspector) override
    {
        inspector.Field("fault", fault, k_Faults, "Where it throws");
    }

private:
    std::unique_ptr<ProbePass> m_Pass;
};

} // namespace probe

LIMN_PLUGIN(features, components)
{
    features.Register<probe::ProbeFeature>("ProbeFeature");
    components.Register<probe::Probe>("Probe");
}

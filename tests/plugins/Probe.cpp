#include "ProbeFault.h"

#include <limn/core/CoreUtils.h>
#include <limn/core/DrawError.h>
#include <limn/core/Inspector.h>
#include <limn/core/RenderGraph.h>
#include <limn/core/UniversalFrameData.h>
#include <limn/features/Features.h>
#include <limn/features/Plugin.h>
#include <limn/volume/NumberParameters.h>
#include <limn/volume/VolumeStack.h>

// A plug-in of the tests: it paints the picture red, or throws where its setting says.

namespace probe
{

using namespace limn;

const volatile char k_BuiltFault[] = "limn probe fault 0";
static_assert(sizeof(k_BuiltFault) == sizeof(k_FaultMark) + 1);

/// Inline with a static variable, of which two copies of a module must not have one in common.
inline Fault BuiltFault()
{
    static const auto fault = static_cast<Fault>(k_BuiltFault[sizeof(k_FaultMark) - 1] - '0');
    return fault;
}

template <typename Error>
void ThrowIf(bool isFault, const Error& error)
{
    if (isFault)
    {
        throw error;
    }
}

class Probe final : public VolumeComponent
{
public:
    Probe()
    {
        ThrowIf(BuiltFault() == Fault::ComponentConstructor, std::runtime_error("no paint at all"));
    }

    void Override(VolumeComponent& state, float interpFactor) const override
    {
        ThrowIf(BuiltFault() == Fault::Blend, std::runtime_error("paints do not mix"));
        VolumeComponent::Override(state, interpFactor);
    }

    ClampedFloatParameter strength{this, "strength", 0.25f,
                                   0.0f, 1.0f,       {.tooltip = "How red the picture gets."}};
};

constexpr EnumEntry k_Faults[] = {{"None", 0},
                                  {"Create", 1},
                                  {"AddRenderPasses", 2},
                                  {"Culling", 3},
                                  {"Setup", 4},
                                  {"Execute", 5},
                                  {"Nameless", 6},
                                  {"Draw", 7},
                                  {"File", 8},
                                  {"RecordRenderGraph", 9},
                                  {"RenderFunction", 10}};

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
        ThrowIf(m_Fault == Fault::Setup, std::out_of_range("no such texture"));
    }

    void Execute(ScriptableRenderContext& context, RenderingData& renderingData) override
    {
        ThrowIf(m_Fault == Fault::Execute, std::runtime_error("the brush is gone"));
        ThrowIf(m_Fault == Fault::Nameless, 42);
        ThrowIf(m_Fault == Fault::Draw, DrawError("a target is missing"));
        ThrowIf(m_Fault == Fault::File, AssetError("brush.png", {}, "there is no such file"));
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

/// Draws nothing.
class ProbeGraphPass final : public ScriptableRenderPass
{
public:
    explicit ProbeGraphPass(Fault fault) : m_Fault(fault)
    {
        profilingSampler = ProfilingSampler("Graph");
    }

    void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer&) override
    {
        ThrowIf(m_Fault == Fault::RecordRenderGraph, std::runtime_error("no paper"));
        PassData* passData = nullptr;
        auto builder = renderGraph.AddUnsafePass<PassData>("Wash", passData);
        builder.SetRenderFunc([](PassData&, UnsafeGraphContext&)
                              { throw std::runtime_error("no water"); });
    }

private:
    struct PassData
    {
    };

    Fault m_Fault;
};

class ProbeFeature final : public ScriptableRendererFeature
{
public:
    ProbeFeature() { ThrowIf(BuiltFault() == Fault::Constructor, std::runtime_error("no canvas")); }

    Fault fault = BuiltFault();

    void Create() override
    {
        ThrowIf(fault == Fault::Create, std::runtime_error("out of paint"));
        m_Pass.reset();
    }

    float cullingMargin(const VolumeStackPointer&) const override
    {
        ThrowIf(fault == Fault::Culling, std::runtime_error("no margin"));
        return 0.0f;
    }

    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) override
    {
        ThrowIf(fault == Fault::AddRenderPasses, std::logic_error("not today"));
        if (!m_Pass)
        {
            m_Pass = std::make_unique<ProbePass>(
                fault, FindShippedShader("Hidden/Probe", renderer.shaderCompiler()));
        }
        m_Pass->strength = renderingData.volumeStack->GetComponent<Probe>()->strength.value();
        renderer.EnqueuePass(*m_Pass);
        if (fault == Fault::RecordRenderGraph || fault == Fault::RenderFunction)
        {
            m_GraphPass = std::make_unique<ProbeGraphPass>(fault);
            renderer.EnqueuePass(*m_GraphPass);
        }
    }

    void Describe(Inspector& inspector) override
    {
        ThrowIf(BuiltFault() == Fault::Describe, std::runtime_error("lost for words"));
        inspector.Field("fault", fault, k_Faults, "Where it throws");
    }

private:
    std::unique_ptr<ProbePass> m_Pass;
    std::unique_ptr<ProbeGraphPass> m_GraphPass;
};

} // namespace probe

LIMN_PLUGIN(features, components)
{
    probe::ThrowIf(probe::BuiltFault() == probe::Fault::Registration,
                   std::runtime_error("nothing to sell"));
    features.Register<probe::ProbeFeature>(
        "ProbeFeature", {{.name = "Red paint", .summary = "paints all of the picture"}});
    components.Register<probe::Probe>("Probe");
}

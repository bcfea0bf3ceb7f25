#include "resolve/DrawResolver.h"

#include <algorithm>
#include <cmath>
#include <limn/base/NumberText.h>
#include <limn/core/DrawError.h>

namespace limn
{

namespace
{

/// Reads the properties that a pass's state refers to.
class StateReader
{
public:
    StateReader(const RenderState& state, const Material& material, const FrameGlobals& globals,
                bool& readsGlobals, std::vector<std::string>* unset)
        : m_State(state),
          m_Material(material),
          m_Globals(globals),
          m_ReadsGlobals(readsGlobals),
          m_Unset(unset)
    {
    }

    template <typename Enum>
    Enum Read(const StateValue<Enum>& value, const char* command, int lowest, int highest) const
    {
        if (value.property.empty())
        {
            return value.value;
        }
        const double number = std::round(Number(value.property, command));
        if (!(number >= lowest && number <= highest))
        {
            Fail(value.property, command,
                 "is " + NumberText(number) + ", which is outside " + std::to_string(lowest) +
                     "..." + std::to_string(highest));
        }
        return static_cast<Enum>(static_cast<int>(number));
    }

    bool Read(const StateValue<bool>& value, const char* command) const
    {
        return value.property.empty() ? value.value : Number(value.property, command) != 0.0;
    }

    float Read(const StateValue<float>& value, const char* command) const
    {
        return value.property.empty() ? value.value
                                      : static_cast<float>(Number(value.property, command));
    }

private:
    double Number(const std::string& property, const char* command) const
    {
        const ShaderPropertyId id(property);
        const ShaderPropertyValue* value = m_Material.Find(id);
        if (value == nullptr)
        {
            value = m_Globals.Find(id);
            m_ReadsGlobals = true;
        }
        if (value == nullptr)
        {
            if (m_Unset != nullptr)
            {
                m_Unset->push_back(std::string(command) + " [" + property + "]");
            }
            return 0.0;
        }
        if (const float* number = std::get_if<float>(value))
        {
            return *number;
        }
        if (const int* number = std::get_if<int>(value))
        {
            return *number;
        }
        Fail(property, command, "is no number");
    }

    [[noreturn]] void Fail(const std::string& property, const char* command,
                           const std::string& what) const
    {
        throw DrawError("material '" + m_Material.name() + "', shader '" +
                        m_Material.shader()->name() + "': " + command + " [" + property +
                        "]: the property " + what + Place());
    }

    /// "; the pass is at toon.shader:12:9", if the state is that of a pass.
    std::string Place() const
    {
        const ShaderLabDocument& document = m_Material.shader()->document();
        const std::vector<ShaderLabPass>& passes = m_Material.shader()->subShader().passes;
        const auto pass = std::ranges::find_if(passes, [this](const auto& known)
                                               { return &known.state == &m_State; });
        if (pass == passes.end())
        {
            return {};
        }
        const std::string file = pass->program ? pass->program->file : document.file;
        return "; the pass is at " + file + ":" + std::to_string(pass->location.line) + ":" +
               std::to_string(pass->location.column);
    }

    const RenderState& m_State;
    const Material& m_Material;
    const FrameGlobals& m_Globals;
    bool& m_ReadsGlobals;
    std::vector<std::string>* m_Unset; ///< may be null
};

constexpr int k_MaxCompare = static_cast<int>(CompareFunction::Always);
constexpr int k_MaxStencilOp = static_cast<int>(StencilOp::DecrementWrap);

RenderTargetBlendState ResolveBlend(const PassBlendState& state, const StateReader& reader)
{
    const auto mode = [&](const StateValue<BlendMode>& value)
    {
        return reader.Read(value, "Blend", 0, static_cast<int>(BlendMode::OneMinusSrcAlpha));
    };
    const auto operation = [&](const StateValue<BlendOp>& value)
    {
        return reader.Read(value, "BlendOp", 0, static_cast<int>(BlendOp::HSLLuminosity));
    };
    RenderTargetBlendState off;
    off.writeMask = reader.Read(state.writeMask, "ColorMask", 0, ColorWriteMask::All);
    RenderTargetBlendState result = off;
    result.sourceColorBlendMode = mode(state.sourceColorBlendMode);
    result.destinationColorBlendMode = mode(state.destinationColorBlendMode);
    result.sourceAlphaBlendMode = mode(state.sourceAlphaBlendMode);
    result.destinationAlphaBlendMode = mode(state.destinationAlphaBlendMode);
    result.colorBlendOperation = operation(state.colorBlendOperation);
    result.alphaBlendOperation = operation(state.alphaBlendOperation);
    return state.enabled ? result : off;
}

StencilFace ResolveFace(const StencilFaceState& state, const StateReader& reader)
{
    return {reader.Read(state.compare, "Comp", 0, k_MaxCompare),
            reader.Read(state.pass, "Pass", 0, k_MaxStencilOp),
            reader.Read(state.fail, "Fail", 0, k_MaxStencilOp),
            reader.Read(state.zFail, "ZFail", 0, k_MaxStencilOp)};
}

} // namespace

PipelineState ResolveState(const RenderState& state, const Material& material,
                           const FrameGlobals& globals, bool* readsGlobals,
                           std::vector<std::string>* unset)
{
    bool isGlobal = false;
    const StateReader reader(state, material, globals, readsGlobals ? *readsGlobals : isGlobal,
                             unset);
    PipelineState result;
    result.cull = reader.Read(state.cull, "Cull", 0, static_cast<int>(CullMode::Back));
    result.zTest = reader.Read(state.zTest, "ZTest", 0, k_MaxCompare);
    result.zWrite = reader.Read(state.zWrite, "ZWrite");
    result.zClip = reader.Read(state.zClip, "ZClip");
    result.offsetFactor = reader.Read(state.offsetFactor, "Offset");
    result.offsetUnits = reader.Read(state.offsetUnits, "Offset");
    result.alphaToMask = reader.Read(state.alphaToMask, "AlphaToMask");
    result.conservative = reader.Read(state.conservative, "Conservative");
    for (std::size_t i = 0; i < result.targets.size(); ++i)
    {
        // Seldom is one blended in another way than the first.
        result.targets[i] = i > 0 && state.targets[i] == state.targets[0]
                                ? result.targets[0]
                                : ResolveBlend(state.targets[i], reader);
    }
    result.stencilEnabled = state.stencil.enabled;
    if (state.stencil.enabled)
    {
        result.stencilReference = reader.Read(state.stencil.reference, "Ref", 0, 255);
        result.stencilReadMask = reader.Read(state.stencil.readMask, "ReadMask", 0, 255);
        result.stencilWriteMask = reader.Read(state.stencil.writeMask, "WriteMask", 0, 255);
        result.stencilFront = ResolveFace(state.stencil.front, reader);
        result.stencilBack = ResolveFace(state.stencil.back, reader);
    }
    return result;
}

} // namespace limn

#pragma once

#include "GpuTestDevice.h"
#include "GpuTestFrame.h"

#include <limn/core/FrameCommands.h>
#include <optional>

namespace limn::test
{

/// No other test has these.
inline std::uint64_t NewStructure()
{
    static std::uint64_t last = std::uint64_t{1} << 32U;
    return ++last;
}

inline Rgba8 TexelOf(const TargetPtr& target)
{
    return Texel8(ReadRows(*target), 0, 0);
}

inline std::uint64_t RecordedFrames()
{
    return SharedDevice().statistics().recordedFrames;
}

/// Vertices in clip space; every texel what the texture holds at its place.
inline PassPtr FetchPass()
{
    static const PassPtr pass = CompilePass(R"(
        Texture2D _Source;
        float4 vert(float3 position : POSITION) : SV_POSITION { return float4(position, 1); }
        float4 frag(float4 p : SV_POSITION) : SV_Target { return _Source.Load(int3(p.xy, 0)); })");
    return pass;
}

/// Every texel what the third component of the object's place holds, as a fraction of 255.
inline PassPtr ObjectPass()
{
    static const PassPtr pass = CompilePass(R"(
        struct PerDraw { float4x4 m; float4x4 i; float4 p; uint4 l; };
        StructuredBuffer<PerDraw> limn_PerDraw;
        StructuredBuffer<uint> limn_Instances;
        struct Varyings { float4 position : SV_POSITION; float value : TEXCOORD0; };
        Varyings vert(float3 position : POSITION, uint id : SV_InstanceID)
        {
            Varyings result;
            result.position = float4(position, 1);
            result.value = limn_PerDraw[limn_Instances[id]].p.z;
            return result;
        }
        float4 frag(Varyings v) : SV_Target { return v.value / 255.0; })");
    return pass;
}

/// A target in one colour.
class ColorFrames
{
public:
    CompiledFrame Make(Color color, std::uint64_t structure)
    {
        CompiledFrame frame;
        const DrawCommand draw = MakeColorDraw(frame, m_Quad, color);
        CompiledRenderPass pass = ClearPass(target);
        pass.commands.emplace_back(draw);
        frame.passes.push_back(std::move(pass));
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        frame.structure = structure;
        return frame;
    }

    /// What it draws.
    Rgba8 Draw(Color color, std::uint64_t structure)
    {
        SharedDevice().Execute(Make(color, structure));
        return TexelOf(target);
    }

    TargetPtr target = MakeTarget(2, 2);

private:
    MeshPtr m_Quad = MakeQuad();
};

/// `source` is cleared, and drawn into `target` from where it lies.
class CopyFrames
{
public:
    CompiledFrame Make(Color color, std::uint64_t structure, std::uint64_t offset = 0)
    {
        CompiledFrame frame;
        CompiledRenderPass copy = ClearPass(target);
        copy.barriers.push_back({source, TextureUsage::ColorAttachment, TextureUsage::ShaderRead});
        DrawBindings bindings;
        bindings.textures.push_back({FetchPass()->layout.textures.at(0).binding, source, {}});
        copy.commands.emplace_back(MakeDraw(frame, FetchPass(), m_Quad, PlainState(), bindings));
        frame.passes = {ClearPass(source, color), copy};
        frame.finalBarriers.push_back(
            {target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        const TextureFootprint needs = SharedDevice().Footprint(*source);
        frame.placed.push_back({source, needs.kind, offset * needs.alignment, needs.size});
        frame.structure = structure;
        return frame;
    }

    Rgba8 Draw(Color color, std::uint64_t structure, std::uint64_t offset = 0)
    {
        SharedDevice().Execute(Make(color, structure, offset));
        return TexelOf(target);
    }

    TargetPtr source = MakeTarget(2, 2);
    TargetPtr target = MakeTarget(2, 2);

private:
    MeshPtr m_Quad = MakeQuad();
};

/// Objects that may be changed, each with one value.
class ValueTable final : public InstanceData
{
public:
    explicit ValueTable(std::vector<float> values) : m_Values(std::move(values)) {}

    std::uint64_t id() const override { return m_Id; }
    std::uint64_t version() const override { return m_Version; }
    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_Values.size()); }
    PerDrawData Get(std::uint32_t object) const override
    {
        PerDrawData data{};
        data.worldTransformParams[2] = m_Values.at(object);
        return data;
    }
    std::optional<std::span<const std::uint32_t>> ChangedSince(std::uint64_t version) const override
    {
        return version == m_Version ? std::optional(std::span<const std::uint32_t>{})
                                    : std::nullopt;
    }

    void Set(std::vector<float> values)
    {
        m_Values = std::move(values);
        ++m_Version;
    }

private:
    std::vector<float> m_Values;
    std::uint64_t m_Id = NewStructure();
    std::uint64_t m_Version = 1;
};

/// A target that shows the value of one object.
class ObjectFrames
{
public:
    Rgba8 Draw(std::uint32_t object, std::uint64_t structure)
    {
        CompiledFrame frame;
        DrawBindings bindings;
        for (const StorageBufferBinding& buffer : ObjectPass()->layout.storageBuffers)
        {
            if (buffer.name == "limn_PerDraw")
            {
                bindings.perDrawBinding = buffer.binding;
            }
        }
        DrawCommand draw = MakeDraw(frame, ObjectPass(), m_Quad, PlainState(), bindings);
        draw.drawsObjects = true;
        CompiledRenderPass pass = ClearPass(m_Target);
        pass.commands.emplace_back(draw);
        frame.passes = {pass};
        frame.finalBarriers.push_back(
            {m_Target, TextureUsage::ColorAttachment, TextureUsage::CopySource});
        frame.objects = table;
        frame.instances = {object};
        frame.structure = structure;
        SharedDevice().Execute(frame);
        return TexelOf(m_Target);
    }

    std::shared_ptr<ValueTable> table =
        std::make_shared<ValueTable>(std::vector<float>{10.0f, 20.0f, 30.0f});

private:
    TargetPtr m_Target = MakeTarget(1, 1);
    MeshPtr m_Quad = MakeQuad();
};

inline constexpr Rgba8 k_OnlyRed{255, 0, 0, 255};
inline constexpr Rgba8 k_OnlyGreen{0, 255, 0, 255};
inline constexpr Rgba8 k_OnlyBlue{0, 0, 255, 255};

inline Rgba8 Gray(int value)
{
    return {value, value, value, value};
}

} // namespace limn::test

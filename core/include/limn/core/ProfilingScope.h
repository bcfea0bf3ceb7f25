#pragma once

#include <limn/core/CommandBuffer.h>
#include <string>
#include <string_view>

namespace limn
{

class BaseCommandBuffer;
class ComputeCommandBuffer;

/// A name for a group of GPU work. Unity: UnityEngine.Rendering.ProfilingSampler (core 14).
class ProfilingSampler
{
public:
    explicit ProfilingSampler(std::string_view name) : m_Name(name) {}
    const std::string& name() const { return m_Name.name(); }
    SampleName sampleName() const { return m_Name; }

    /// Begins and ends the group by hand; a ProfilingScope cannot forget the end.
    void Begin(CommandBuffer& cmd) const { cmd.BeginSample(m_Name); }
    void End(CommandBuffer& cmd) const { cmd.EndSample(); }

private:
    SampleName m_Name;
};

/// Names everything that `cmd` records while the scope lives. The buffer may be executed in parts
/// within the scope: the end is recorded into the same buffer.
/// Unity: UnityEngine.Rendering.ProfilingScope (core 14).
class ProfilingScope
{
public:
    ProfilingScope(CommandBuffer& cmd, const ProfilingSampler& sampler) : m_Cmd(cmd)
    {
        m_Cmd.BeginSample(sampler.sampleName());
    }
    /// Names what a pass of a render graph records.
    ProfilingScope(BaseCommandBuffer& cmd, const ProfilingSampler& sampler);
    ProfilingScope(ComputeCommandBuffer& cmd, const ProfilingSampler& sampler);
    ~ProfilingScope() { m_Cmd.EndSample(); }
    ProfilingScope(const ProfilingScope&) = delete;
    ProfilingScope& operator=(const ProfilingScope&) = delete;

private:
    CommandBuffer& m_Cmd;
};

} // namespace limn

#pragma once

#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"
#include "plugins/ProbeFault.h"

namespace limn::test
{

/// A module of tests/plugins, as it was built.
inline std::filesystem::path BuiltPlugin(const std::string& name)
{
    const auto built = std::filesystem::path(LimnExecutable()).parent_path().parent_path();
    return built / "tests" / "plugins" / name;
}

/// `bytes` with a text of them changed to one as long.
inline std::string Patched(std::string bytes, const std::string& text, const std::string& now)
{
    const std::size_t at = bytes.find(text);
    if (at == std::string::npos || text.size() != now.size())
    {
        throw std::logic_error("there is no '" + text + "' to write '" + now + "' over");
    }
    return bytes.replace(at, now.size(), now);
}

/// probe.so, as if it were built to throw there.
inline std::string FaultyProbe(probe::Fault fault)
{
    const std::string mark = probe::k_FaultMark;
    return Patched(ReadText(BuiltPlugin("probe.so")), mark + "0",
                   mark + static_cast<char>('0' + static_cast<int>(fault)));
}

/// probe.so, as if its shader were changed to paint green.
inline std::string GreenProbe()
{
    return Patched(ReadText(BuiltPlugin("probe.so")), "half4(_Strength, 0, 0, 1)",
                   "half4(0, _Strength, 0, 1)");
}

/// A scene that the plug-in paints all of.
inline void WriteProbeScene(const TemporaryFolder& folder, const std::string& feature,
                            const std::string& more = "")
{
    folder.Write("s.scene.yaml", "size: [8, 8]\ncamera: {}\n" + more + "renderer: {features: [" +
                                     feature + "]}\nvolumes: [{profile: p.profile.yaml}]\n");
}

/// A folder with scenes for the plug-ins of tests/plugins, links to which lie in it. `limn` runs
/// as a process of its own, as a plug-in stays in the process for ever.
class PluginFolder
{
public:
    PluginFolder()
    {
        for (const char* file :
             {"probe.so", "old_plugin.so", "other_build.so", "no_plugin.so", "missing_symbol.so"})
        {
            std::filesystem::create_symlink(BuiltPlugin(file), file);
        }
        m_Working.folder.Write("text.so", "no library at all\n");
        m_Working.folder.Write("p.profile.yaml", "Probe: {strength: 0.75}\n");
        WriteScene("{type: ProbeFeature}");
    }

    /// A scene that has this feature.
    void WriteScene(const std::string& feature, const std::string& more = "") const
    {
        WriteProbeScene(m_Working.folder, feature, more);
    }

    void Write(const std::string& name, const std::string& bytes) const
    {
        m_Working.folder.Write(name, bytes);
    }

    /// stdout and stderr of `limn ARGUMENTS`, and "exit N" behind them.
    static std::string Run(const std::string& arguments)
    {
        return RunInPipe("'" + LimnExecutable() + "' " + arguments + " 2>&1; echo exit $?");
    }

private:
    WorkingFolder m_Working;
};

} // namespace limn::test

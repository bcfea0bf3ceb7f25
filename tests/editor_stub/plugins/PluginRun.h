#pragma once

#include "commands/CommandRun.h"
#include "commands/WorkingFolder.h"

namespace limn::test
{

/// A folder with scenes for the plug-ins of tests/plugins, copies of which lie in it. `limn` runs
/// as a process of its own, as a plug-in stays in the process for ever.
class PluginFolder
{
public:
    PluginFolder()
    {
        const auto built = std::filesystem::path(LimnExecutable()).parent_path().parent_path();
        for (const char* module : {"probe", "old_plugin", "other_build", "no_plugin"})
        {
            const std::string file = std::string(module) + ".so";
            std::filesystem::create_symlink(built / "tests" / "plugins" / file, file);
        }
        m_Working.folder.Write("text.so", "no library at all\n");
        m_Working.folder.Write("p.profile.yaml", "Probe: {strength: 0.75}\n");
        WriteScene("{type: ProbeFeature}");
    }

    /// A scene that has this feature.
    void WriteScene(const std::string& feature, const std::string& more = "") const
    {
        m_Working.folder.Write("s.scene.yaml", "size: [8, 8]\ncamera: {}\n" + more +
                                                   "renderer: {features: [" + feature +
                                                   "]}\nvolumes: [{profile: p.profile.yaml}]\n");
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

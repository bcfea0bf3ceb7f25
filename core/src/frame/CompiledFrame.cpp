#include <limn/core/CompiledFrame.h>

#include <algorithm>

namespace limn
{

std::vector<std::string> CompiledRenderPass::SampleNames() const
{
    std::vector<std::string> names;
    const auto add = [&](const std::string& sample)
    {
        if (!sample.empty() && std::ranges::find(names, sample) == names.end())
        {
            names.push_back(sample);
        }
    };
    add(name);
    for (const PassCommand& command : commands)
    {
        if (const auto* sample = std::get_if<BeginSampleCommand>(&command))
        {
            add(sample->name.name());
        }
    }
    return names;
}

std::string CompiledRenderPass::Title() const
{
    std::string title;
    for (const std::string& sample : SampleNames())
    {
        title += (title.empty() ? "" : " + ") + sample;
    }
    return title;
}

} // namespace limn

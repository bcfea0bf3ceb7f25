#include "settings/SettingName.h"

#include "plugins/DescribeFeature.h"

#include <algorithm>
#include <limn/volume/YamlMapReader.h>

namespace limn
{

namespace
{

class NameCollector final : public Inspector
{
public:
    void Field(const FieldInfo& field, FieldValue) override
    {
        m_Groups.back().members.push_back({std::string(field.name)});
    }
    void BeginGroup(std::string_view name) override
    {
        m_Groups.push_back({std::string(name), true});
    }
    void EndGroup() override
    {
        SettingName group = std::move(m_Groups.back());
        m_Groups.pop_back();
        m_Groups.back().members.push_back(std::move(group));
    }

    SettingName Root() && { return std::move(m_Groups.front()); }

private:
    std::vector<SettingName> m_Groups{{"", true}}; ///< that are open, the outermost first
};

void AddPaths(const SettingName& owner, const SettingName& group, const std::string& prefix,
              std::vector<std::string>& paths)
{
    for (const SettingName& member : owner.members)
    {
        if (&owner != &group)
        {
            paths.push_back(prefix + member.name);
        }
        AddPaths(member, group, prefix + member.name + ".", paths);
    }
}

} // namespace

SettingName DescribedSettings(ScriptableRendererFeature& feature)
{
    NameCollector collector;
    DescribeFeature(feature, collector);
    return std::move(collector).Root();
}

const SettingName* FindMember(const SettingName& group, std::string_view key)
{
    const auto found =
        std::ranges::find_if(group.members, [key](const SettingName& member)
                             { return member.name == key || PlainSpelling(member.name) == key; });
    return found == group.members.end() ? nullptr : &*found;
}

std::vector<std::string> PathsOutside(const SettingName& root, const SettingName& group)
{
    std::vector<std::string> paths;
    AddPaths(root, group, "", paths);
    return paths;
}

} // namespace limn

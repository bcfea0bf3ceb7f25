#include "settings/ReadValues.h"
#include "settings/ShadowKeys.h"

#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

/// An error unless the shares rise between 0 and 1.
void CheckSplits(YamlMapReader& map, std::string_view name, std::initializer_list<float> shares,
                 AssetDiagnostics& diagnostics)
{
    float before = 0.0f;
    bool rises = *(shares.end() - 1) < 1.0f;
    for (const float share : shares)
    {
        rises = rises && share > before;
        before = share;
    }
    const YamlNode* node = map.Find(name);
    if (!rises && node)
    {
        diagnostics.Error(node->location(),
                          map.SubjectOf(name) +
                              ": shares between 0 and 1 are expected, each above the one before");
    }
}

} // namespace

void ReadShadowSettings(YamlMapReader& map, ShadowSettings& settings, AssetDiagnostics& diagnostics)
{
    const auto read = [&](std::string_view name, auto& value, ValueRange range, std::string_view)
    {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, SoftShadowQuality>)
        {
            const YamlNode* node = map.Find(name);
            const auto quality =
                node ? ReadEnum(*node, k_SoftShadowQualities, map.SubjectOf(name), diagnostics)
                     : std::nullopt;
            value = quality ? static_cast<SoftShadowQuality>(*quality) : value;
        }
        else if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, glm::vec2>)
        {
            map.Read(name, value);
        }
        else
        {
            map.Read(name, value, range);
        }
    };
    VisitShadowSettings(settings, read);
    const ShadowSettings& s = settings;
    switch (s.shadowCascadeCount) // splits of other counts have no effect
    {
    case 2:
        CheckSplits(map, "m_Cascade2Split", {s.cascade2Split}, diagnostics);
        break;
    case 3:
        CheckSplits(map, "m_Cascade3Split", {s.cascade3Split.x, s.cascade3Split.y}, diagnostics);
        break;
    case 4:
        CheckSplits(map, "m_Cascade4Split",
                    {s.cascade4Split.x, s.cascade4Split.y, s.cascade4Split.z}, diagnostics);
        break;
    default:
        break;
    }
}

} // namespace limn

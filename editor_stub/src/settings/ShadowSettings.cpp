#include "settings/ReadEnum.h"
#include "settings/ShadowKeys.h"

#include <limn/base/Diagnostic.h>

namespace limn
{

namespace
{

/// Reads one setting after the other.
class ShadowReader
{
public:
    ShadowReader(YamlMapReader& map, AssetDiagnostics& diagnostics)
        : m_Map(map), m_Diagnostics(diagnostics)
    {
    }

    void operator()(std::string_view name, bool& value, ValueRange, std::string_view)
    {
        m_Map.Read(name, value);
    }
    template <typename Number>
    void operator()(std::string_view name, Number& value, ValueRange range, std::string_view)
    {
        m_Map.Read(name, value, range);
    }
    void operator()(std::string_view name, glm::vec2& value, ValueRange, std::string_view)
    {
        m_Map.Read(name, value);
    }
    void operator()(std::string_view name, SoftShadowQuality& value, ValueRange, std::string_view)
    {
        if (const YamlNode* node = m_Map.Find(name))
        {
            const auto quality =
                ReadEnum(*node, k_SoftShadowQualities, m_Map.SubjectOf(name), m_Diagnostics);
            value = quality ? static_cast<SoftShadowQuality>(*quality) : value;
        }
    }

private:
    YamlMapReader& m_Map;
    AssetDiagnostics& m_Diagnostics;
};

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
    ShadowReader reader(map, diagnostics);
    VisitShadowSettings(settings, reader);
    const ShadowSettings& s = settings;
    CheckSplits(map, "m_Cascade2Split", {s.cascade2Split}, diagnostics);
    CheckSplits(map, "m_Cascade3Split", {s.cascade3Split.x, s.cascade3Split.y}, diagnostics);
    CheckSplits(map, "m_Cascade4Split", {s.cascade4Split.x, s.cascade4Split.y, s.cascade4Split.z},
                diagnostics);
}

} // namespace limn

#include "ParameterValues.h"

#include <cmath>
#include <limn/volume/YamlMapReader.h>

namespace limn::detail
{

namespace
{

/// A slope may be infinite, as Unity writes it.
bool ReadTangent(YamlMapReader& map, std::string_view key, AssetDiagnostics& diagnostics,
                 float& value)
{
    const YamlNode* node = map.Find(key);
    if (!node)
    {
        return false;
    }
    const bool isNegative = node->scalar() == "-Infinity" || node->scalar() == "-.inf";
    if (isNegative || node->scalar() == "Infinity" || node->scalar() == ".inf")
    {
        const float infinity = std::numeric_limits<float>::infinity();
        value = isNegative ? -infinity : infinity;
        return true;
    }
    const auto read = ReadFloat(*node, map.SubjectOf(key), diagnostics);
    value = read.value_or(value);
    return read.has_value();
}

Keyframe ReadKey(const ValueSource& source)
{
    Keyframe key;
    YamlMapReader map(source.node, std::string(source.subject), source.diagnostics);
    if (map.Require("time"))
    {
        map.Read("time", key.time);
    }
    if (map.Require("value"))
    {
        map.Read("value", key.value);
    }
    const bool isUnitys = source.node.Find("inSlope") || source.node.Find("outSlope");
    ReadTangent(map, isUnitys ? "inSlope" : "inTangent", source.diagnostics, key.inTangent);
    ReadTangent(map, isUnitys ? "outSlope" : "outTangent", source.diagnostics, key.outTangent);
    map.Read("inWeight", key.inWeight);
    map.Read("outWeight", key.outWeight);
    int mode = 0;
    map.Read("weightedMode", mode, {0, 3});
    key.weightedMode = static_cast<WeightedMode>(mode);
    map.Find("serializedVersion");
    map.Find("tangentMode"); // how Unity's editor keeps the tangents; nothing to evaluate
    map.Finish();
    return key;
}

std::string KeyText(const Keyframe& key)
{
    std::string text = "{time: " + LimnText(key.time) + ", value: " + LimnText(key.value) +
                       ", inTangent: " + UnityText(key.inTangent) +
                       ", outTangent: " + UnityText(key.outTangent);
    if (key.inWeight != 0.0f || key.outWeight != 0.0f || key.weightedMode != WeightedMode::None)
    {
        text += ", inWeight: " + LimnText(key.inWeight) +
                ", outWeight: " + LimnText(key.outWeight) +
                ", weightedMode: " + std::to_string(static_cast<int>(key.weightedMode));
    }
    return text + "}";
}

std::string UnityKeyText(const Keyframe& key)
{
    return "{serializedVersion: 3, time: " + UnityText(key.time) +
           ", value: " + UnityText(key.value) + ", inSlope: " + UnityText(key.inTangent) +
           ", outSlope: " + UnityText(key.outTangent) +
           ", tangentMode: 0, weightedMode: " + std::to_string(static_cast<int>(key.weightedMode)) +
           ", inWeight: " + UnityText(key.inWeight) + ", outWeight: " + UnityText(key.outWeight) +
           "}";
}

template <typename Text>
std::string KeysText(const AnimationCurve& curve, Text&& text)
{
    std::string list = "[";
    for (const Keyframe& key : curve.keys())
    {
        list += (list.size() > 1 ? ", " : "") + text(key);
    }
    return list + "]";
}

} // namespace

bool ReadValue(const ValueSource& source, AnimationCurve& value)
{
    const YamlNode* list = source.node.isMap() ? source.node.Find("m_Curve") : &source.node;
    if (!list || !list->isSequence())
    {
        return source.Refuse("found " + source.node.Describe() +
                             "; a list of keys is expected, [{time: 0, value: 1}], or Unity's "
                             "{m_Curve: [...]}");
    }
    const std::size_t before = source.diagnostics.diagnostics().size();
    std::vector<Keyframe> keys;
    for (const YamlNode& item : list->items())
    {
        const std::string subject =
            std::string(source.subject) + "[" + std::to_string(keys.size()) + "]";
        keys.push_back(ReadKey({item, subject, source.diagnostics, {}}));
    }
    if (source.diagnostics.diagnostics().size() != before)
    {
        return false;
    }
    value.SetKeys(std::move(keys));
    return true;
}

bool ReadValue(const ValueSource& source, TextureCurve& value)
{
    if (!source.node.isMap())
    {
        return source.Refuse("found " + source.node.Describe() +
                             "; a map is expected, {keys: [{time: 0, value: 1}], zeroValue: 0, "
                             "loop: false, range: 1}");
    }
    const std::size_t before = source.diagnostics.diagnostics().size();
    YamlMapReader map(source.node, std::string(source.subject), source.diagnostics);
    const bool isUnitys = source.node.Find("m_Curve") != nullptr;
    const std::string_view key = isUnitys ? "m_Curve" : "keys";
    AnimationCurve curve;
    if (const YamlNode* keys = map.Require(key))
    {
        ReadValue({*keys, map.SubjectOf(key), source.diagnostics, {}}, curve);
    }
    float zeroValue = 0.0f;
    bool loop = false;
    float range = 1.0f;
    map.Read("m_ZeroValue", zeroValue);
    map.Read("m_Loop", loop);
    map.Read("m_Range", range, {0.0});
    map.Find("<length>k__BackingField"); // Unity's count of the keys
    map.Finish();
    if (source.diagnostics.diagnostics().size() != before)
    {
        return false;
    }
    value = TextureCurve(std::move(curve), zeroValue, loop, range);
    return true;
}

std::string LimnText(const AnimationCurve& value)
{
    return KeysText(value, KeyText);
}

std::string LimnText(const TextureCurve& value)
{
    return "{keys: " + LimnText(value.curve()) + ", zeroValue: " + LimnText(value.zeroValue()) +
           ", loop: " + LimnText(value.loop()) + ", range: " + LimnText(value.range()) + "}";
}

std::string UnityText(const AnimationCurve& value)
{
    return "{serializedVersion: 2, m_Curve: " + KeysText(value, UnityKeyText) +
           ", m_PreInfinity: 2, m_PostInfinity: 2, m_RotationOrder: 4}";
}

std::string UnityText(const TextureCurve& value)
{
    return "{<length>k__BackingField: " + std::to_string(value.curve().length()) +
           ", m_Loop: " + UnityText(value.loop()) +
           ", m_ZeroValue: " + UnityText(value.zeroValue()) +
           ", m_Range: " + UnityText(value.range()) + ", m_Curve: " + UnityText(value.curve()) +
           "}";
}

} // namespace limn::detail

#include "parameters/ParameterValues.h"

#include <algorithm>
#include <array>
#include <limn/base/Lists.h>
#include <limn/volume/CurveParameters.h>
#include <limn/volume/YamlMapReader.h>

namespace limn::detail
{

namespace
{

/// A slope may be infinite, as Unity writes it.
void ReadTangent(YamlMapReader& map, std::string_view key, float& value)
{
    const YamlNode* node = map.Find(key);
    const std::string_view text = node ? std::string_view(node->scalar()) : "";
    const bool isNegative = text == "-Infinity" || text == "-.inf";
    if (isNegative || text == "Infinity" || text == ".inf")
    {
        const float infinity = std::numeric_limits<float>::infinity();
        value = isNegative ? -infinity : infinity;
        return;
    }
    map.Read(key, value);
}

Keyframe ReadKey(const ValueSource& source)
{
    Keyframe key;
    YamlMapReader map(source.node, std::string(source.subject), source.diagnostics);
    map.Require("time");
    map.Read("time", key.time);
    map.Require("value");
    map.Read("value", key.value);
    const bool isUnitys = source.node.Find("inSlope") || source.node.Find("outSlope");
    ReadTangent(map, isUnitys ? "inSlope" : "inTangent", key.inTangent);
    ReadTangent(map, isUnitys ? "outSlope" : "outTangent", key.outTangent);
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

const EnumNames k_WrapModes{{"Loop", 2}, {"PingPong", 4}, {"ClampForever", 8},
                            {"Once", 1}, {"Clamp", 1},    {"Default", 0}};

/// The wrap modes in the order of the numbers of Unity's player, which differ from those of
/// WrapMode.
constexpr std::array<WrapMode, 3> k_UnityWrapModes{WrapMode::PingPong, WrapMode::Loop,
                                                   WrapMode::ClampForever};

WrapMode ReadWrapMode(YamlMapReader& map, std::string_view key, bool isUnitys,
                      AssetDiagnostics& diagnostics)
{
    int number = 2;
    if (isUnitys)
    {
        map.Read(key, number, {0, 2});
        return k_UnityWrapModes[static_cast<std::size_t>(number)];
    }
    const YamlNode* node = map.Find(key);
    const auto read =
        node ? ReadEnum(*node, map.SubjectOf(key), diagnostics, k_WrapModes) : std::nullopt;
    return read ? static_cast<WrapMode>(*read) : WrapMode::ClampForever;
}

void ReadWrapModes(const ValueSource& source, bool isUnitys, AnimationCurve& curve)
{
    YamlMapReader map(source.node, std::string(source.subject), source.diagnostics);
    const auto read = [&](std::string_view key)
    {
        return ReadWrapMode(map, key, isUnitys, source.diagnostics);
    };
    curve.SetPreWrapMode(read(isUnitys ? "m_PreInfinity" : "preWrapMode"));
    curve.SetPostWrapMode(read(isUnitys ? "m_PostInfinity" : "postWrapMode"));
    if (!isUnitys) // Unity's form holds more, which depends on its version
    {
        map.Find("keys");
        map.Finish();
    }
}

std::string UnityWrapMode(WrapMode mode)
{
    const auto* found = std::find(k_UnityWrapModes.begin(), k_UnityWrapModes.end(), mode);
    return std::to_string(found - k_UnityWrapModes.begin());
}

} // namespace

bool ReadValue(const ValueSource& source, AnimationCurve& value)
{
    const bool isUnitys = source.node.Find("m_Curve") != nullptr;
    const YamlNode* list = isUnitys              ? source.node.Find("m_Curve")
                           : source.node.isMap() ? source.node.Find("keys")
                                                 : &source.node;
    if (!list || !list->isSequence())
    {
        return source.Refuse("found " + source.node.Describe() +
                             "; a list of keys is expected, [{time: 0, value: 1}], or Unity's "
                             "{m_Curve: [...]}");
    }
    const std::size_t before = source.diagnostics.errorCount();
    std::vector<Keyframe> keys;
    for (const YamlNode& item : list->items())
    {
        const std::string subject =
            std::string(source.subject) + "[" + std::to_string(keys.size()) + "]";
        keys.push_back(ReadKey(source.At(item, subject)));
    }
    AnimationCurve curve(std::move(keys));
    if (source.node.isMap())
    {
        ReadWrapModes(source, isUnitys, curve);
    }
    if (source.diagnostics.errorCount() != before)
    {
        return false;
    }
    value = std::move(curve);
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
    const std::size_t before = source.diagnostics.errorCount();
    YamlMapReader map(source.node, std::string(source.subject), source.diagnostics);
    const bool isUnitys = source.node.Find("m_Curve") != nullptr;
    const std::string_view key = isUnitys ? "m_Curve" : "keys";
    AnimationCurve curve;
    if (const YamlNode* keys = map.Require(key))
    {
        ReadValue(source.At(*keys, map.SubjectOf(key)), curve);
    }
    float zeroValue = 0.0f;
    bool loop = false;
    float range = 1.0f;
    map.Read("m_ZeroValue", zeroValue);
    map.Read("m_Loop", loop);
    map.Read("m_Range", range, {0.0});
    map.Find("<length>k__BackingField"); // Unity's count of the keys
    map.Finish();
    if (source.diagnostics.errorCount() != before)
    {
        return false;
    }
    value = TextureCurve(std::move(curve), zeroValue, loop, range);
    return true;
}

std::string LimnText(const AnimationCurve& value)
{
    const std::string keys = "[" + Joined(value.keys(), ", ", KeyText) + "]";
    const auto clamped = WrapMode::ClampForever;
    if (value.preWrapMode() == clamped && value.postWrapMode() == clamped)
    {
        return keys;
    }
    const auto name = [](WrapMode mode)
    {
        return EnumText(static_cast<std::int64_t>(mode), k_WrapModes);
    };
    return "{keys: " + keys + ", preWrapMode: " + name(value.preWrapMode()) +
           ", postWrapMode: " + name(value.postWrapMode()) + "}";
}

std::string LimnText(const TextureCurve& value)
{
    return "{keys: " + LimnText(value.curve()) + ", zeroValue: " + LimnText(value.zeroValue()) +
           ", loop: " + LimnText(value.loop()) + ", range: " + LimnText(value.range()) + "}";
}

std::string UnityText(const AnimationCurve& value)
{
    return "{serializedVersion: 2, m_Curve: [" + Joined(value.keys(), ", ", UnityKeyText) +
           "], m_PreInfinity: " + UnityWrapMode(value.preWrapMode()) +
           ", m_PostInfinity: " + UnityWrapMode(value.postWrapMode()) + ", m_RotationOrder: 4}";
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

namespace limn
{

void AnimationCurveParameter::Interp(const AnimationCurve& from, const AnimationCurve& to, float t)
{
    if (&to == &m_Value)
    {
        const AnimationCurve target = to;
        m_Value = from;
        KeyframeUtility::InterpAnimationCurve(m_Value, target, t);
        return;
    }
    m_Value = from;
    KeyframeUtility::InterpAnimationCurve(m_Value, to, t);
}

} // namespace limn

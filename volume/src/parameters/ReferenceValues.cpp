#include "parameters/ParameterValues.h"
#include "yaml/Text.h"

#include <limn/volume/YamlMapReader.h>

namespace limn::detail
{

namespace
{

/// The index of a layer by its name or number; nothing, with an error, if there is none.
std::optional<int> ReadLayer(const ValueSource& item, bool hasNames)
{
    if (!hasNames || !item.node.isScalar() || LooksLikeNumber(item.node))
    {
        return ReadInt(item.node, item.subject, item.diagnostics, {0, 31});
    }
    const std::string& name = item.node.scalar();
    const std::optional<int> index = item.context.FindLayer(name);
    if (!index)
    {
        item.Refuse("unknown layer " + UnknownName(name, item.context.layerNames()));
    }
    return index;
}

template <typename Mask>
bool ReadList(const ValueSource& source, bool hasNames, Mask& value)
{
    bool isGood = true;
    Mask result;
    for (const YamlNode& item : source.node.items())
    {
        const std::optional<int> index = ReadLayer(source.At(item, source.subject), hasNames);
        isGood = isGood && index;
        result = result | Mask::FromIndex(index.value_or(0));
    }
    value = isGood ? result : value;
    return isGood;
}

template <typename Mask>
bool ReadMask(const ValueSource& source, bool hasNames, Mask& value)
{
    const YamlNode& node = source.node;
    if (node.isSequence())
    {
        return ReadList(source, hasNames, value);
    }
    if (node.scalar() == "Everything" || node.scalar() == "Nothing")
    {
        value = node.scalar() == "Everything" ? Mask::Everything() : Mask::Nothing();
        return true;
    }
    if (hasNames && node.isScalar() && !LooksLikeNumber(node))
    {
        const std::optional<int> index = ReadLayer(source, hasNames);
        value = index ? Mask::FromIndex(*index) : value;
        return index.has_value();
    }
    const YamlNode* bits = node.Find("m_Bits");
    const auto number = ReadInteger(bits ? *bits : node, source.subject, source.diagnostics,
                                    {0, static_cast<double>(Mask::Everything().bits)});
    value = number ? Mask(static_cast<std::uint32_t>(*number)) : value;
    return number.has_value();
}

} // namespace

bool ReadValue(const ValueSource& source, LayerMask& value)
{
    return ReadMask(source, true, value);
}

bool ReadValue(const ValueSource& source, RenderingLayerMask& value)
{
    return ReadMask(source, false, value);
}

bool ReadValue(const ValueSource& source, AssetLocation& value)
{
    const YamlNode& node = source.node;
    if (node.isSequence())
    {
        return source.Refuse("found " + node.Describe() +
                             "; a path, or Unity's {fileID: 0}, is expected");
    }
    AssetLocation read;
    read.path = node.scalar();
    if (node.isMap())
    {
        const std::size_t before = source.diagnostics.errorCount();
        YamlMapReader map(node, std::string(source.subject), source.diagnostics);
        map.Require("fileID");
        map.Read("fileID", read.fileID);
        map.Read("guid", read.guid);
        map.Read("type", read.type);
        map.Finish();
        if (source.diagnostics.errorCount() != before)
        {
            return false;
        }
    }
    value = std::move(read);
    return true;
}

std::string LimnText(LayerMask value)
{
    return std::to_string(value.bits);
}

std::string LimnText(RenderingLayerMask value)
{
    return std::to_string(value.bits);
}

std::string LimnText(const AssetLocation& value)
{
    return value.path.empty() && value.fileID != 0 ? UnityText(value) : InQuotes(value.path, '"');
}

std::string UnityText(LayerMask value)
{
    return "{serializedVersion: 2, m_Bits: " + std::to_string(value.bits) + "}";
}

std::string UnityText(RenderingLayerMask value)
{
    return "{serializedVersion: 0, m_Bits: " + std::to_string(value.bits) + "}";
}

std::string UnityText(const AssetLocation& value)
{
    const std::string fileID = "{fileID: " + std::to_string(value.fileID);
    return value.guid.empty()
               ? fileID + "}"
               : fileID + ", guid: " + value.guid + ", type: " + std::to_string(value.type) + "}";
}

} // namespace limn::detail

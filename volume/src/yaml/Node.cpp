#include <limn/volume/YamlNode.h>

#include <algorithm>

namespace limn
{

YamlNode::YamlNode()
{
    static const std::shared_ptr<const YamlContent> null = std::make_shared<YamlContent>();
    m_Content = null;
}

YamlNode::YamlNode(YamlContent content)
    : m_Content(std::make_shared<const YamlContent>(std::move(content)))
{
}

YamlKind YamlNode::kind() const
{
    return m_Content->kind;
}

SourceLocation YamlNode::location() const
{
    return m_Content->location;
}

const std::string& YamlNode::scalar() const
{
    return m_Content->scalar;
}

bool YamlNode::isQuoted() const
{
    return m_Content->quoted;
}

const std::string& YamlNode::tag() const
{
    return m_Content->tag;
}

const std::string& YamlNode::anchor() const
{
    return m_Content->anchor;
}

std::span<const YamlNode> YamlNode::items() const
{
    return m_Content->items;
}

std::span<const YamlEntry> YamlNode::entries() const
{
    return m_Content->entries;
}

const YamlNode* YamlNode::Find(std::string_view key) const
{
    const std::vector<YamlEntry>& entries = m_Content->entries;
    const auto found = std::ranges::find(entries, key, &YamlEntry::key);
    return found == entries.end() ? nullptr : &found->value;
}

std::string YamlNode::Describe() const
{
    switch (kind())
    {
    case YamlKind::Scalar:
        return "'" + scalar() + "'";
    case YamlKind::Sequence:
        return "a sequence";
    case YamlKind::Map:
        return "a map";
    case YamlKind::Null:
        break;
    }
    return "nothing";
}

} // namespace limn

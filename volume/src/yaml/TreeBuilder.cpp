#include "yaml/TreeBuilder.h"

#include "yaml/Text.h"

#include <algorithm>
#include <utility>

namespace limn
{

void YamlTreeBuilder::CheckEnd()
{
    if (m_LastQuoted && !IsQuoteClosed(m_Text, static_cast<std::size_t>(m_LastQuoted->pos)))
    {
        m_Diagnostics.Error(ToLocation(*m_LastQuoted),
                            "this is not valid YAML: the quote is never closed");
    }
}

void YamlTreeBuilder::OnDocumentStart(const YAML::Mark& mark)
{
    m_Anchors.clear();
    const std::string_view rest =
        m_Text.substr(std::min(m_Text.size(), static_cast<std::size_t>(mark.pos)));
    if (!documents.empty() && rest.substr(0, 3) != "---")
    {
        Stop(ToLocation(mark),
             "text follows the end of the document; another document begins with a line '---'");
    }
}

void YamlTreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor)
{
    YamlContent content = Begin(mark, "");
    if (!m_Open.empty() && m_Open.back().pending)
    {
        content.location = m_Open.back().pending->keyLocation;
    }
    Finish({YamlNode(std::move(content))}, anchor);
}

void YamlTreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag,
                               YAML::anchor_t anchor, const std::string& value)
{
    YamlContent content = Begin(mark, tag);
    content.kind = YamlKind::Scalar;
    content.quoted = tag == "!";
    content.scalar = value;
    if (content.quoted)
    {
        m_LastQuoted = mark;
    }
    Finish({YamlNode(std::move(content))}, anchor);
}

void YamlTreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor)
{
    const auto found = m_Anchors.find(anchor);
    if (found == m_Anchors.end())
    {
        Stop(ToLocation(mark), "the alias refers to a value that contains it");
    }
    CheckDepth(ToLocation(mark), found->second);
    m_RepeatedCount += found->second.count;
    if (m_RepeatedCount > m_Limits.repeatedValues)
    {
        Stop(ToLocation(mark), "the file's aliases repeat more than " +
                                   std::to_string(m_Limits.repeatedValues) + " values");
    }
    Append(ToLocation(mark), found->second);
}

void YamlTreeBuilder::Stop(SourceLocation location, std::string message)
{
    m_Diagnostics.Error(location, std::move(message));
    throw StopReading{};
}

YamlContent YamlTreeBuilder::Begin(const YAML::Mark& mark, const std::string& tag)
{
    YamlContent content;
    content.location = ToLocation(mark);
    content.tag = tag == "?" || tag == "!" ? "" : tag;
    content.anchor = std::exchange(m_AnchorName, {});
    return content;
}

void YamlTreeBuilder::Open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           YamlKind kind)
{
    OpenNode open;
    open.content = Begin(mark, tag);
    open.content.kind = kind;
    open.anchorId = anchor;
    CheckSize(open.content.location, {{}, 1, 1});
    m_Open.push_back(std::move(open));
}

void YamlTreeBuilder::Close()
{
    OpenNode open = std::move(m_Open.back());
    m_Open.pop_back();
    const BuiltNode built{YamlNode(std::move(open.content)), open.count, open.height};
    if (open.anchorId != 0)
    {
        m_Anchors[open.anchorId] = built;
    }
    // The inner values were counted against the limit when they came.
    Append(built.node.location(), built);
}

void YamlTreeBuilder::Finish(const BuiltNode& built, YAML::anchor_t anchor)
{
    CheckSize(built.node.location(), built);
    if (anchor != 0)
    {
        m_Anchors[anchor] = built;
    }
    Append(built.node.location(), built);
}

void YamlTreeBuilder::CheckDepth(SourceLocation location, const BuiltNode& added)
{
    if (m_Open.size() + added.height > m_Limits.depth)
    {
        Stop(location,
             "values are nested more than " + std::to_string(m_Limits.depth) + " levels deep");
    }
}

void YamlTreeBuilder::CheckSize(SourceLocation location, const BuiltNode& added)
{
    CheckDepth(location, added);
    if (++m_Count > m_Limits.values)
    {
        Stop(location, "the file has more than " + std::to_string(m_Limits.values) + " values");
    }
}

void YamlTreeBuilder::Append(SourceLocation location, const BuiltNode& built)
{
    if (m_Open.empty())
    {
        documents.push_back(built.node);
        return;
    }
    OpenNode& parent = m_Open.back();
    parent.count += built.count;
    parent.height = std::max(parent.height, built.height + 1);
    if (parent.content.kind == YamlKind::Sequence)
    {
        parent.content.items.push_back(built.node);
    }
    else if (!parent.pending)
    {
        parent.pending = MakeKey(location, built.node);
        parent.isPendingText = built.node.isScalar();
    }
    else
    {
        parent.pending->value = built.node;
        AddPending(parent);
    }
}

YamlEntry YamlTreeBuilder::MakeKey(SourceLocation location, const YamlNode& node)
{
    if (!node.isScalar())
    {
        m_Diagnostics.Error(location, "the key is " + node.Describe() +
                                          "; a key is plain text, 'key: value'");
    }
    return {node.scalar(), location, {}};
}

void YamlTreeBuilder::AddPending(OpenNode& parent)
{
    YamlEntry entry = std::move(*parent.pending);
    parent.pending.reset();
    if (!parent.isPendingText)
    {
        return;
    }
    const auto [first, isNew] = parent.keys.emplace(entry.key, entry.keyLocation);
    if (isNew)
    {
        parent.content.entries.push_back(std::move(entry));
        return;
    }
    m_Diagnostics.Error(entry.keyLocation, "duplicate key '" + entry.key + "'; it is already at " +
                                               std::to_string(first->second.line) + ":" +
                                               std::to_string(first->second.column));
}

} // namespace limn

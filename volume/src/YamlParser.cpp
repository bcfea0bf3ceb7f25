#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>

#include "YamlFlowScan.h"
#include "YamlText.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <unordered_map>
#include <utility>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace limn
{

namespace
{

constexpr int k_MaxDepth = 64;
constexpr std::size_t k_MaxNodes = 5'000'000;
constexpr std::size_t k_MaxRepeatedNodes = 1'000'000; ///< by aliases
/// yaml-cpp holds all tokens of a flow collection until it ends, some hundred bytes each.
constexpr std::size_t k_MaxFlowBytes = std::size_t{8} * 1024 * 1024;

SourceLocation ToLocation(const YAML::Mark& mark)
{
    return {mark.line + 1, mark.column + 1};
}

/// A finished node and what it counts for wherever an alias repeats it.
struct BuiltNode
{
    YamlNode node;
    std::size_t count = 1;
    int height = 0; ///< levels of sequences and maps
};

/// A sequence or map whose end has not come yet.
struct OpenNode
{
    YamlContent content;
    YAML::anchor_t anchorId = 0;
    std::size_t count = 1;
    int height = 1;
    std::optional<YamlEntry> pending; ///< a key that waits for its value
    bool isPendingText = true;        ///< false: the key was refused, its value goes nowhere
    std::unordered_map<std::string, SourceLocation> keys;
};

/// Ends the reading of a file whose last error says why.
struct StopReading
{
};

/// Turns yaml-cpp's events into YamlNodes and fences off what yaml-cpp lets pass: duplicate keys,
/// bombs, text behind the end of a document.
class TreeBuilder final : public YAML::EventHandler
{
public:
    TreeBuilder(std::string_view text, AssetDiagnostics& diagnostics)
        : m_Text(text), m_Diagnostics(diagnostics)
    {
    }

    std::vector<YamlNode> documents;

    void OnDocumentStart(const YAML::Mark& mark) override
    {
        m_Anchors.clear();
        const std::string_view rest =
            m_Text.substr(std::min(m_Text.size(), static_cast<std::size_t>(mark.pos)));
        if (!documents.empty() && rest.substr(0, 3) != "---")
        {
            Stop(ToLocation(mark), "text after the end of the document; another document begins "
                                   "with a line '---'");
        }
    }

    void OnDocumentEnd() override {}

    void OnAnchor(const YAML::Mark&, const std::string& name) override { m_AnchorName = name; }

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override
    {
        YamlContent content = Begin(mark, "");
        if (!m_Open.empty() && m_Open.back().pending)
        {
            content.location = m_Open.back().pending->keyLocation;
        }
        Finish({YamlNode(std::move(content))}, anchor);
    }

    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override
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

    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override
    {
        const auto found = m_Anchors.find(anchor);
        if (found == m_Anchors.end())
        {
            Stop(ToLocation(mark), "the alias refers to a value it is itself a part of");
        }
        CheckDepth(ToLocation(mark), found->second);
        m_RepeatedCount += found->second.count;
        if (m_RepeatedCount > k_MaxRepeatedNodes)
        {
            Stop(ToLocation(mark), "the file's aliases repeat more than " +
                                       std::to_string(k_MaxRepeatedNodes) + " values");
        }
        Append(ToLocation(mark), found->second);
    }

    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override
    {
        Open(mark, tag, anchor, YamlKind::Sequence);
    }

    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override
    {
        Open(mark, tag, anchor, YamlKind::Map);
    }

    /// What yaml-cpp lets pass without an event. Call when there are no more documents.
    void CheckEnd()
    {
        if (m_LastQuoted && !IsQuoteClosed(m_Text, static_cast<std::size_t>(m_LastQuoted->pos)))
        {
            m_Diagnostics.Error(ToLocation(*m_LastQuoted),
                                "not valid YAML: the quote is never closed");
        }
    }

    /// The innermost sequence or map that has begun; null outside of any.
    const YamlContent* innermost() const
    {
        return m_Open.empty() ? nullptr : &m_Open.back().content;
    }

    void OnSequenceEnd() override { Close(); }

    void OnMapEnd() override { Close(); }

private:
    [[noreturn]] void Stop(SourceLocation location, std::string message)
    {
        m_Diagnostics.Error(location, std::move(message));
        throw StopReading{};
    }

    YamlContent Begin(const YAML::Mark& mark, const std::string& tag)
    {
        YamlContent content;
        content.location = ToLocation(mark);
        content.tag = tag == "?" || tag == "!" ? "" : tag;
        content.anchor = std::exchange(m_AnchorName, {});
        return content;
    }

    void Open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlKind kind)
    {
        OpenNode open;
        open.content = Begin(mark, tag);
        open.content.kind = kind;
        open.anchorId = anchor;
        CheckSize(open.content.location, {{}, 1, 1});
        m_Open.push_back(std::move(open));
    }

    void Close()
    {
        OpenNode open = std::move(m_Open.back());
        m_Open.pop_back();
        const BuiltNode built{YamlNode(std::move(open.content)), open.count, open.height};
        if (open.anchorId != 0)
        {
            m_Anchors[open.anchorId] = built;
        }
        // What is inside was counted against the limit when it came.
        Append(built.node.location(), built);
    }

    void Finish(const BuiltNode& built, YAML::anchor_t anchor)
    {
        CheckSize(built.node.location(), built);
        if (anchor != 0)
        {
            m_Anchors[anchor] = built;
        }
        Append(built.node.location(), built);
    }

    void CheckDepth(SourceLocation location, const BuiltNode& added)
    {
        if (m_Open.size() + static_cast<std::size_t>(added.height) > k_MaxDepth)
        {
            Stop(location,
                 "values are nested more than " + std::to_string(k_MaxDepth) + " levels deep");
        }
    }

    void CheckSize(SourceLocation location, const BuiltNode& added)
    {
        CheckDepth(location, added);
        if (++m_Count > k_MaxNodes)
        {
            Stop(location, "the file has more than " + std::to_string(k_MaxNodes) + " values");
        }
    }

    void Append(SourceLocation location, const BuiltNode& built)
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

    YamlEntry MakeKey(SourceLocation location, const YamlNode& node)
    {
        if (!node.isScalar())
        {
            m_Diagnostics.Error(location, "the key is " + node.Describe() +
                                              "; a key is plain text, 'key: value'");
        }
        return {node.scalar(), location, {}};
    }

    void AddPending(OpenNode& parent)
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
        m_Diagnostics.Error(entry.keyLocation, "duplicate key '" + entry.key +
                                                   "'; it is already at " +
                                                   std::to_string(first->second.line) + ":" +
                                                   std::to_string(first->second.column));
    }

    std::string_view m_Text;
    AssetDiagnostics& m_Diagnostics;
    std::vector<OpenNode> m_Open;
    std::unordered_map<YAML::anchor_t, BuiltNode> m_Anchors; ///< finished ones of this document
    std::string m_AnchorName;                                ///< of the node that comes next
    std::optional<YAML::Mark> m_LastQuoted;
    std::size_t m_Count = 0; ///< of values the file holds itself
    std::size_t m_RepeatedCount = 0;
};

/// yaml-cpp's words for a syntax error, put so that a person finds the spot.
void ReportSyntaxError(const YAML::Exception& e, const YamlContent* innermost,
                       AssetDiagnostics& diagnostics)
{
    SourceLocation location = ToLocation(e.mark);
    std::string message = e.msg;
    if (e.msg == YAML::ErrorMsg::END_OF_MAP || e.msg == YAML::ErrorMsg::END_OF_SEQ)
    {
        message = "this line does not belong to what is above it; check its indentation";
    }
    else if (e.msg == YAML::ErrorMsg::MAP_VALUE)
    {
        message = "a ':' is out of place; check the indentation and the line above, or put the "
                  "text in quotes";
    }
    else if ((e.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW ||
              e.msg == YAML::ErrorMsg::END_OF_MAP_FLOW) &&
             innermost)
    {
        location = innermost->location;
        message = innermost->kind == YamlKind::Map ? "the '{' here is not closed by a '}'"
                                                   : "the '[' here is not closed by a ']'";
    }
    diagnostics.Error(location, "not valid YAML: " + message);
}

void CheckIsText(std::string_view text, const std::string& file)
{
    const std::optional<std::size_t> offset = FindNonText(text);
    if (offset && text[*offset] == '\0')
    {
        throw AssetError(file, LocationOf(text, *offset),
                         "a NUL byte: this is a binary file or UTF-16; UTF-8 text is expected");
    }
    if (offset)
    {
        throw AssetError(file, LocationOf(text, *offset),
                         "the bytes here are not UTF-8; save the file as UTF-8 text");
    }
}

void CheckFlow(std::string_view text, const std::string& file)
{
    if (const std::optional<std::size_t> offset = FindLongFlow(text, k_MaxFlowBytes))
    {
        throw AssetError(file, LocationOf(text, *offset),
                         "the list or map in brackets here is longer than " +
                             std::to_string(k_MaxFlowBytes) +
                             " bytes (8 MiB); put its items on lines of their own, behind '- '");
    }
}

} // namespace

std::vector<YamlNode> ParseYaml(std::string_view text, const std::string& file)
{
    CheckIsText(text, file);
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, byteOrderMark.size()) == byteOrderMark)
    {
        text.remove_prefix(byteOrderMark.size());
    }
    CheckFlow(text, file);
    AssetDiagnostics diagnostics(file);
    TreeBuilder builder(text, diagnostics);
    try
    {
        std::istringstream stream{std::string(text)};
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder))
        {
        }
        builder.CheckEnd();
    }
    catch (const StopReading&)
    {
        diagnostics.ThrowIfErrors();
    }
    catch (const YAML::Exception& e)
    {
        ReportSyntaxError(e, builder.innermost(), diagnostics);
    }
    diagnostics.ThrowIfErrors();
    const bool isEmpty = std::all_of(builder.documents.begin(), builder.documents.end(),
                                     [](const YamlNode& document) { return document.isNull(); });
    if (isEmpty)
    {
        throw AssetError(file, {}, "is empty; it begins with a name and a colon, 'name:'");
    }
    return std::move(builder.documents);
}

} // namespace limn

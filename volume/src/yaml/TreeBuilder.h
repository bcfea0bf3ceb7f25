#pragma once

#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

namespace limn
{

/// An exception that ends the reading of a file; the last error says why.
struct StopReading
{
};

/// Turns yaml-cpp's events into YamlNodes and rejects what yaml-cpp accepts: duplicate keys, bombs,
/// text behind the end of a document.
class YamlTreeBuilder final : public YAML::EventHandler
{
public:
    YamlTreeBuilder(std::string_view text, const YamlLimits& limits, AssetDiagnostics& diagnostics,
                    int firstLine)
        : m_Text(text), m_Limits(limits), m_Diagnostics(diagnostics), m_FirstLine(firstLine)
    {
    }

    SourceLocation ToLocation(const YAML::Mark& mark) const
    {
        return {mark.line + m_FirstLine, mark.column + 1};
    }

    std::vector<YamlNode> documents;

    /// Rejects what yaml-cpp accepts without an event. Must be called when there are no more
    /// documents.
    void CheckEnd();

    /// Returns the innermost sequence or map that has begun, or null outside of any.
    const YamlContent* innermost() const
    {
        return m_Open.empty() ? nullptr : &m_Open.back().content;
    }

    void OnDocumentStart(const YAML::Mark& mark) override;
    void OnDocumentEnd() override {}
    void OnAnchor(const YAML::Mark&, const std::string& name) override { m_AnchorName = name; }
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override;
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
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
    void OnSequenceEnd() override { Close(); }
    void OnMapEnd() override { Close(); }

private:
    /// A finished node and the number of values it adds wherever an alias repeats it.
    struct BuiltNode
    {
        YamlNode node;
        std::size_t count = 1;
        std::size_t height = 0; ///< levels of sequences and maps
    };

    /// A sequence or map that has not ended yet.
    struct OpenNode
    {
        YamlContent content;
        YAML::anchor_t anchorId = 0;
        std::size_t count = 1;
        std::size_t height = 1;
        std::optional<YamlEntry> pending; ///< a key that waits for its value
        bool isPendingText = true;        ///< false: the key was refused, its value goes nowhere
        std::unordered_map<std::string, SourceLocation> keys;
    };

    [[noreturn]] void Stop(SourceLocation location, std::string message);
    YamlContent Begin(const YAML::Mark& mark, const std::string& tag);
    void Open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlKind kind);
    void Close();
    void Finish(const BuiltNode& built, YAML::anchor_t anchor);
    void CheckDepth(SourceLocation location, const BuiltNode& added);
    void CheckSize(SourceLocation location, const BuiltNode& added);
    void Append(SourceLocation location, const BuiltNode& built);
    YamlEntry MakeKey(SourceLocation location, const YamlNode& node);
    void AddPending(OpenNode& parent);

    std::string_view m_Text;
    YamlLimits m_Limits;
    AssetDiagnostics& m_Diagnostics;
    int m_FirstLine;
    std::vector<OpenNode> m_Open;
    std::unordered_map<YAML::anchor_t, BuiltNode> m_Anchors; ///< finished ones of this document
    std::string m_AnchorName; ///< the anchor of the node that comes next
    std::optional<YAML::Mark> m_LastQuoted;
    std::size_t m_Count = 0; ///< the number of values in the file itself
    std::size_t m_RepeatedCount = 0;
};

} // namespace limn

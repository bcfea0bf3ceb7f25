#pragma once

#include <limn/volume/AssetDiagnostics.h>
#include <limn/volume/YamlNode.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Replaces scalars of a YAML text, adds lines, and leaves every other byte as it is.
class YamlSplicer
{
public:
    /// @param subject  the name of the value in errors
    YamlSplicer(std::string_view text, std::string subject, AssetDiagnostics& diagnostics);

    /// Replaces `old`, a value of the text, with `fresh`, in the style of `old`. A problem is an
    /// error in the diagnostics.
    /// @param freshText  `fresh` on one line
    void Replace(const YamlNode& old, const YamlNode& fresh, const std::string& freshText);

    /// Adds a key to a map of the text, as a line in the style of its lines, or within its braces.
    /// A problem is an error in the diagnostics.
    /// @param map        a map of the text; a Null that belongs to a key may become a map
    /// @param valueText  on one line
    void Insert(const YamlNode& map, const std::string& key, const std::string& valueText);

    /// Adds a map of one key behind everything else of a text whose root is a map.
    void Append(const YamlNode& root, const std::string& name, const std::string& key,
                const std::string& valueText);

    /// Returns the number of scalars replaced and lines added so far.
    std::size_t count() const { return m_Splices.size(); }
    std::string Result() const;

    /// @param after  the documents of Result()
    /// @throws AssetError  at `place` if more than the replaced scalars has changed, because an
    ///     alias repeats one
    void RequireNoOtherChange(std::span<const YamlNode> before, std::span<const YamlNode> after,
                              SourceLocation place) const;

private:
    struct Splice
    {
        std::size_t begin;
        std::size_t end;
        std::string text;
    };

    void Refuse(const YamlNode& node, const std::string& problem);
    void ReplaceMap(const YamlNode& old, const YamlNode& fresh);
    void ReplaceSequence(const YamlNode& old, const YamlNode& fresh);
    void ReplaceScalar(const YamlNode& old, const YamlNode& fresh);
    /// Returns the characters of a scalar, its quotes included; empty if it is not on one line.
    std::string_view Extent(const YamlNode& scalar) const;
    void Add(const YamlNode& old, std::string fresh);
    void AddAt(std::string_view extent, std::string fresh);
    /// Puts a value behind a key that has none.
    void FillIn(const YamlNode& null, const std::string& freshText);
    /// Returns the characters of a list or map in brackets; empty if it is something else or not on
    /// one line.
    std::string_view FlowExtent(const YamlNode& node) const;

    /// Returns the characters of a value; empty if it takes more than one line.
    std::string_view OneLineExtent(const YamlNode& value) const;
    /// Adds a line behind the line that contains a place.
    void AddLineBehind(std::size_t place, const std::string& line);
    std::string_view EndOfLine() const; ///< "\n" or "\r\n", as the text has it

    std::string_view m_Text;
    std::string m_Subject;
    AssetDiagnostics& m_Diagnostics;
    std::vector<Splice> m_Splices;
};

/// Returns the text from the place of one of its nodes on.
std::string_view TextFrom(std::string_view text, const YamlNode& node);

} // namespace limn

#pragma once

#include <cstddef>
#include <filesystem>
#include <limn/base/Diagnostic.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

enum class YamlKind
{
    Null, ///< nothing, `~` or `null`
    Scalar,
    Sequence,
    Map
};

struct YamlContent;
struct YamlEntry;

/// A value of a YAML file and everything below it. Immutable; copies share the content.
class YamlNode
{
public:
    YamlNode(); ///< Null at no particular place
    explicit YamlNode(YamlContent content);

    YamlKind kind() const;
    bool isNull() const { return kind() == YamlKind::Null; }
    bool isScalar() const { return kind() == YamlKind::Scalar; }
    bool isSequence() const { return kind() == YamlKind::Sequence; }
    bool isMap() const { return kind() == YamlKind::Map; }

    /// Returns the place where the value begins or, for a Null that belongs to a key, where the key
    /// begins.
    SourceLocation location() const;

    const std::string& scalar() const; ///< without quotes, escapes resolved; "" unless a Scalar
    bool isQuoted() const;             ///< 'so', "so" or a block scalar: text, never a number
    const std::string& tag() const;    ///< resolved, "tag:unity3d.com,2011:114"; "" if none given
    const std::string& anchor() const; ///< the name behind &; "" if none given

    std::span<const YamlNode> items() const; ///< the items of a Sequence; empty for any other kind
    /// Returns the entries of a Map, in the order of the file; empty for any other kind.
    std::span<const YamlEntry> entries() const;

    /// Returns the value of a Map's key, or null if there is no such key or this is no Map. The
    /// value lives as long as any copy of this node.
    const YamlNode* Find(std::string_view key) const;

    /// Returns a description of the value for messages: "'text'", "a map", "a sequence", "nothing".
    std::string Describe() const;

private:
    std::shared_ptr<const YamlContent> m_Content; ///< never null
};

/// One line of a map.
struct YamlEntry
{
    std::string key;
    SourceLocation keyLocation;
    YamlNode value;
};

/// The content of a YamlNode; only for code that builds one.
struct YamlContent
{
    YamlKind kind = YamlKind::Null;
    bool quoted = false;
    SourceLocation location;
    std::string scalar;
    std::string tag;
    std::string anchor;
    std::vector<YamlNode> items;
    std::vector<YamlEntry> entries;
};

/// The limits of a YAML text, so that a hostile one takes neither all memory nor all time.
struct YamlLimits
{
    std::size_t depth = 64;                 ///< levels of lists and maps
    std::size_t values = 5'000'000;         ///< values in the file itself
    std::size_t repeatedValues = 1'000'000; ///< values that aliases repeat
    /// The length of a list or map in brackets, in bytes. Until it ends, it takes some hundred
    /// bytes of memory per item.
    std::size_t flowBytes = std::size_t{8} * 1024 * 1024;
};

/// Returns the documents of a YAML text, one root each. Errors use `file` as its name.
/// @param firstLine  the line of that file at which the text begins; every place is counted from it
/// @throws AssetError for text that is not UTF-8 or holds NUL bytes, for a text without any value,
///     broken syntax, every duplicate key, keys that are not plain text, an alias inside its own
///     anchor, and beyond a limit
std::vector<YamlNode> ParseYaml(std::string_view text, const std::string& file,
                                const YamlLimits& limits = {}, int firstLine = 1);

/// Returns the offset behind the quotes with which a YAML text begins, npos if they are not closed,
/// 0 if there are none.
std::size_t EndOfQuotes(std::string_view text);

/// Returns the bytes of a YAML file.
/// @throws AssetError if the file is missing, unreadable, no regular file, or larger than 64 MiB
std::string ReadYamlText(const std::filesystem::path& path);

/// Parses the content of a file with ParseYaml.
/// @throws AssetError as ReadYamlText and ParseYaml do
std::vector<YamlNode> LoadYamlFile(const std::filesystem::path& path);

} // namespace limn

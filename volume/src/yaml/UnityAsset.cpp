#include <limn/volume/UnityAsset.h>

#include <algorithm>
#include <limn/base/ParseWhole.h>
#include <limn/base/Text.h>
#include <limn/volume/AssetDiagnostics.h>

namespace limn
{

namespace
{

constexpr int k_MonoBehaviour = 114;
constexpr std::string_view k_ObjectMark = "--- !u!";
constexpr std::string_view k_NoObject =
    "this document is no Unity object; one begins like '--- !u!114 &11400000' and has one map, "
    "'MonoBehaviour:'";

/// YAML has no place for a word behind the anchor, as "stripped" is; so this is read here.
std::optional<UnityHeader> ReadHeader(std::string_view line)
{
    if (!line.starts_with(k_ObjectMark))
    {
        return std::nullopt;
    }
    line.remove_prefix(k_ObjectMark.size());
    const auto classID = ParseWhole<int>(TakeWord(line));
    const std::string_view anchor = TakeWord(line);
    const auto fileID = ParseWhole<std::int64_t>(anchor.substr(anchor.empty() ? 0 : 1));
    const std::string_view mark = TakeWord(line);
    const bool isStripped = mark == "stripped";
    if (!classID || !anchor.starts_with('&') || !fileID || !(isStripped || mark.empty()) ||
        !TakeWord(line).empty())
    {
        return std::nullopt;
    }
    UnityHeader header;
    header.fileID = *fileID;
    header.classID = *classID;
    header.isStripped = isStripped;
    return header;
}

bool IsDocumentStart(std::string_view line)
{
    return line.starts_with("---") &&
           (line.size() == 3 || line[3] == ' ' || line[3] == '\t' || line[3] == '\r');
}

/// Returns whether the line may stand above the first object; directives and comments may.
bool IsPreamble(std::string_view line)
{
    const std::string_view word = TakeWord(line);
    return word.empty() || word.front() == '%' || word.front() == '#';
}

/// The headers of a text, each with its body; what is wrong goes into the diagnostics.
std::vector<UnityHeader> ScanHeaders(std::string_view text, AssetDiagnostics& diagnostics)
{
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    std::vector<UnityHeader> headers;
    bool hasDocument = false;
    bool isObject = false; ///< the document that the line is in
    std::size_t end = 0;
    int number = 1;
    for (std::size_t at = text.starts_with(byteOrderMark) ? 3 : 0; at < text.size(); at = end + 1)
    {
        end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        if (IsDocumentStart(line) || !(hasDocument || IsPreamble(line)))
        {
            if (isObject)
            {
                headers.back().bodyEnd = at;
            }
            std::optional<UnityHeader> header = ReadHeader(line);
            hasDocument = true;
            isObject = header.has_value();
            if (isObject)
            {
                header->line = number;
                header->bodyBegin = std::min(end + 1, text.size());
                header->bodyEnd = text.size();
                headers.push_back(*header);
            }
            else
            {
                diagnostics.Error({number, 1}, std::string(k_NoObject));
            }
        }
        ++number;
    }
    if (!hasDocument)
    {
        diagnostics.Error({},
                          "the file holds no Unity object; one begins like '--- !u!114 &11400000'");
    }
    return headers;
}

} // namespace

UnityAsset::UnityAsset(std::string text, std::string file)
    : m_Text(std::move(text)), m_File(std::move(file))
{
    AssetDiagnostics diagnostics(m_File);
    m_Headers = ScanHeaders(m_Text, diagnostics);
    for (std::size_t i = 0; i < m_Headers.size(); ++i)
    {
        const auto [same, isNew] = m_ByFileID.emplace(m_Headers[i].fileID, i);
        if (!isNew)
        {
            diagnostics.Error({m_Headers[i].line, 1},
                              "duplicate fileID " + std::to_string(m_Headers[i].fileID) +
                                  "; it is already at " +
                                  std::to_string(m_Headers[same->second].line) + ":1");
        }
    }
    diagnostics.ThrowIfErrors();
}

const UnityHeader* UnityAsset::FindHeader(std::int64_t fileID) const
{
    const auto found = m_ByFileID.find(fileID);
    return found == m_ByFileID.end() ? nullptr : &m_Headers[found->second];
}

std::string_view UnityAsset::BodyOf(const UnityHeader& header) const
{
    return std::string_view(m_Text).substr(header.bodyBegin, header.bodyEnd - header.bodyBegin);
}

UnityObject UnityAsset::Read(const UnityHeader& header) const
{
    const std::string_view body = BodyOf(header);
    std::vector<YamlNode> documents;
    if (body.find_first_not_of(" \t\r\n") != std::string_view::npos)
    {
        documents = ParseYaml(body, m_File, {}, header.line + 1);
    }
    if (documents.size() != 1 || documents.front().entries().size() != 1 ||
        !documents.front().entries().front().value.isMap())
    {
        throw AssetError(m_File, {header.line, 1}, std::string(k_NoObject));
    }
    const YamlEntry& entry = documents.front().entries().front();
    const YamlNode* name = entry.value.Find("m_Name");
    return {header.fileID,     header.classID, entry.key, name ? name->scalar() : std::string(),
            entry.keyLocation, entry.value};
}

std::optional<UnityObject> UnityAsset::Find(std::int64_t fileID) const
{
    const UnityHeader* header = FindHeader(fileID);
    return header ? std::optional(Read(*header)) : std::nullopt;
}

std::optional<UnityObject> UnityAsset::FindWithField(std::string_view field) const
{
    for (const UnityHeader& header : m_Headers)
    {
        if (header.classID != k_MonoBehaviour ||
            BodyOf(header).find(field) == std::string_view::npos)
        {
            continue;
        }
        UnityObject object = Read(header);
        if (object.fields.Find(field))
        {
            return object;
        }
    }
    return std::nullopt;
}

bool IsUnityAsset(std::string_view text)
{
    return text.starts_with(k_ObjectMark) ||
           text.find("\n" + std::string(k_ObjectMark)) != std::string_view::npos;
}

UnityAsset LoadUnityAsset(const std::filesystem::path& path)
{
    return UnityAsset(ReadYamlText(path), path.generic_string());
}

std::optional<std::int64_t> ReadFileID(const YamlNode& reference)
{
    const YamlNode* id = reference.Find("fileID");
    return id ? ParseWhole<std::int64_t>(id->scalar()) : std::nullopt;
}

std::string ReadGuid(const YamlNode& reference)
{
    const YamlNode* guid = reference.Find("guid");
    return guid ? guid->scalar() : std::string();
}

} // namespace limn

#include "compiler/ShaderCache.h"

#include "compiler/ProgramBytes.h"

#include <algorithm>
#include <limn/base/ReadFile.h>
#include <limn/base/WriteFile.h>
#include <string>

namespace limn
{

namespace
{

constexpr std::string_view k_Magic = "limn pass 6\n";
constexpr const char* k_Extension = ".limnpass";

/// The bytes between magic and trailing hash, or nothing if the file is torn.
std::optional<std::string_view> Payload(std::string_view file)
{
    constexpr std::size_t k_HashSize = sizeof(std::uint64_t);
    if (file.size() < k_Magic.size() + k_HashSize || file.substr(0, k_Magic.size()) != k_Magic)
    {
        return std::nullopt;
    }
    const std::string_view payload =
        file.substr(k_Magic.size(), file.size() - k_Magic.size() - k_HashSize);
    std::uint64_t hash = 0;
    ByteReader(file.substr(file.size() - k_HashSize)).Value(hash);
    return hash == HashContent(payload) ? std::optional(payload) : std::nullopt;
}

std::filesystem::path EntryPath(const std::filesystem::path& folder, const std::string& key)
{
    return folder / (key + k_Extension);
}

} // namespace

std::optional<ShaderProgram> ShaderCache::Load(const std::string& key,
                                               std::vector<IncludeDependency>& dependencies) const
{
    dependencies.clear();
    const FileContent file = isEnabled() ? TryReadFile(EntryPath(m_Folder, key)) : FileContent();
    const auto payload = Payload(file.bytes);
    if (!payload)
    {
        return std::nullopt;
    }
    try
    {
        ByteReader reader(*payload);
        std::string ownKey;
        reader.Value(ownKey);
        if (ownKey != key)
        {
            return std::nullopt; // copied or renamed: the name alone does not make it this pass
        }
        Transfer(reader, dependencies);
        const bool isCurrent =
            std::all_of(dependencies.begin(), dependencies.end(),
                        [](const IncludeDependency& dependency)
                        { return HashFile(dependency.path) == dependency.contentHash; });
        ShaderProgram pass;
        Transfer(reader, pass);
        if (!isCurrent)
        {
            return std::nullopt;
        }
        // Trim goes by the time of the last use; that it cannot be set is no reason to compile.
        std::error_code ignored;
        std::filesystem::last_write_time(EntryPath(m_Folder, key),
                                         std::filesystem::file_time_type::clock::now(), ignored);
        return pass;
    }
    catch (const std::out_of_range&)
    {
        return std::nullopt; // an entry of another format with a good hash: rebuilt like a torn one
    }
}

void ShaderCache::Store(const std::string& key, const ShaderProgram& pass,
                        const std::vector<IncludeDependency>& dependencies) const
{
    if (!isEnabled())
    {
        return;
    }
    ByteWriter payload;
    payload.Value(key);
    Transfer(payload, dependencies);
    Transfer(payload, pass);
    ByteWriter hash;
    hash.Value(HashContent(payload.bytes()));

    // Best effort: without an entry the next run compiles again.
    std::error_code error;
    std::filesystem::create_directories(m_Folder, error);
    const std::string bytes = std::string(k_Magic) + payload.bytes() + hash.bytes();
    const std::filesystem::path entry = EntryPath(m_Folder, key);
    if (std::filesystem::is_symlink(entry, error)) // nothing of limn's, and not to be followed
    {
        std::filesystem::remove(entry, error);
    }
    error = TryWriteFile(entry, bytes);
    const std::uintmax_t stored = m_Stored += bytes.size();
    if (m_Limit > 0 && (!m_HasTrimmed.exchange(true) || stored > m_Limit / 8))
    {
        m_Stored = 0;
        Trim();
    }
}

void ShaderCache::Trim() const
{
    struct Entry
    {
        std::filesystem::file_time_type lastUse;
        std::filesystem::path path;
        std::uintmax_t size = 0;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    std::error_code error;
    for (auto file = std::filesystem::directory_iterator(m_Folder, error);
         !error && file != std::filesystem::directory_iterator(); file.increment(error))
    {
        // Another process may be trimming as well: what is gone already counts nothing.
        std::error_code gone;
        const std::uintmax_t size =
            file->path().extension() == k_Extension ? file->file_size(gone) : 0;
        const auto lastUse =
            gone ? std::filesystem::file_time_type::min() : file->last_write_time(gone);
        if (!gone && size > 0)
        {
            entries.push_back({lastUse, file->path(), size});
            total += size;
        }
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.lastUse < b.lastUse; });
    for (std::size_t i = 0; i < entries.size() && total > m_Limit; ++i)
    {
        std::filesystem::remove(entries[i].path, error);
        total -= entries[i].size;
    }
}

} // namespace limn

#include <limn/base/FileCache.h>

#include <algorithm>
#include <limn/base/ByteStream.h>
#include <limn/base/HashContent.h>
#include <limn/base/ReadFile.h>
#include <limn/base/WriteFile.h>
#include <vector>

namespace limn
{

namespace
{

constexpr std::size_t k_HashSize = sizeof(std::uint64_t);
constexpr std::uintmax_t k_MaxEntryBytes = std::uintmax_t{2} << 30;

} // namespace

std::string FileCache::HeaderOf(const std::string& key) const
{
    ByteWriter own; // the name alone does not make a copied or renamed file this one
    own.Value(key);
    return m_Magic + own.bytes();
}

std::optional<FileCache::Entry> FileCache::Load(const std::string& key) const
{
    FileContent file = isEnabled() ? TryReadFile(PathOf(key), k_MaxEntryBytes) : FileContent();
    const std::string header = HeaderOf(key);
    if (file.bytes.size() < header.size() + k_HashSize || !file.bytes.starts_with(header))
    {
        return std::nullopt;
    }
    const std::size_t end = file.bytes.size() - k_HashSize;
    const std::string_view bytes = file.bytes;
    std::uint64_t hash = 0;
    ByteReader(bytes.substr(end)).Value(hash);
    if (hash != HashContent(bytes.substr(m_Magic.size(), end - m_Magic.size())))
    {
        return std::nullopt; // torn
    }
    return Entry{std::move(file.bytes), header.size(), end - header.size()};
}

void FileCache::Touch(const std::string& key) const
{
    // Trim goes by the time of the last use; that it cannot be set is no reason to work again.
    std::error_code ignored;
    std::filesystem::last_write_time(PathOf(key), std::filesystem::file_time_type::clock::now(),
                                     ignored);
}

void FileCache::Store(const std::string& key, std::string_view payload) const
{
    if (!isEnabled() || payload.size() > k_MaxEntryBytes / 2)
    {
        return;
    }
    std::string bytes = HeaderOf(key);
    bytes.reserve(bytes.size() + payload.size() + k_HashSize);
    bytes += payload;
    ByteWriter hash;
    hash.Value(HashContent(std::string_view(bytes).substr(m_Magic.size())));
    bytes += hash.bytes();

    // Best effort: without an entry the next run works again.
    std::error_code error;
    std::filesystem::create_directories(m_Folder, error);
    const std::filesystem::path entry = PathOf(key);
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

void FileCache::Trim() const
{
    struct File
    {
        std::filesystem::file_time_type lastUse;
        std::filesystem::path path;
        std::uintmax_t size = 0;
    };
    std::vector<File> files;
    std::uintmax_t total = 0;
    std::error_code error;
    for (auto file = std::filesystem::directory_iterator(m_Folder, error);
         !error && file != std::filesystem::directory_iterator(); file.increment(error))
    {
        // Another process may be trimming as well: what is gone already counts nothing.
        std::error_code gone;
        const std::uintmax_t size =
            file->path().extension() == m_Extension ? file->file_size(gone) : 0;
        const auto lastUse =
            gone ? std::filesystem::file_time_type::min() : file->last_write_time(gone);
        if (!gone && size > 0)
        {
            files.push_back({lastUse, file->path(), size});
            total += size;
        }
    }
    std::ranges::sort(files, {}, &File::lastUse);
    for (std::size_t i = 0; i < files.size() && total > m_Limit; ++i)
    {
        std::filesystem::remove(files[i].path, error);
        total -= files[i].size;
    }
}

} // namespace limn

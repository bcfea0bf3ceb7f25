#include "unity/GuidIndex.h"

#include <limn/base/ByteStream.h>
#include <limn/base/HashContent.h>
#include <limn/base/ReadFile.h>
#include <sstream>
#include <vector>

namespace limn
{

namespace
{

constexpr std::uintmax_t k_GuidIndexBytes = std::uintmax_t{64} << 20; ///< of all projects

std::string ReadGuid(const std::filesystem::path& metaFile)
{
    constexpr std::string_view k_Key = "guid: ";
    std::istringstream stream(TryReadFile(metaFile).bytes);
    std::string line;
    while (std::getline(stream, line))
    {
        if (std::string_view(line).starts_with(k_Key))
        {
            const std::size_t end = line.find_last_not_of(" \r");
            return line.substr(k_Key.size(), end + 1 - k_Key.size());
        }
    }
    return {};
}

} // namespace

void GuidIndex::Transfer(auto& stream, auto& entry)
{
    stream.Values(entry.first, entry.second.size, entry.second.time, entry.second.guid);
}

GuidIndex::GuidIndex(const std::filesystem::path& root, const std::filesystem::path& cacheFolder)
    : m_Cache(cacheFolder, ".limnguids", "limn guids 1\n", k_GuidIndexBytes),
      m_Key("project-" + std::to_string(HashContent(root.generic_string())))
{
    const std::optional<FileCache::Entry> kept = m_Cache.Load(m_Key);
    if (!kept)
    {
        return;
    }
    try
    {
        std::vector<std::pair<std::string, Entry>> entries;
        ByteReader reader(kept->payload());
        reader.List(entries, [&](auto& entry) { Transfer(reader, entry); });
        m_Kept = Entries(std::move_iterator(entries.begin()), std::move_iterator(entries.end()));
    }
    catch (const std::out_of_range&)
    {
        // one of another format
    }
}

std::string GuidIndex::GuidOf(const std::filesystem::directory_entry& metaFile)
{
    std::error_code failure;
    Entry entry;
    entry.size = metaFile.file_size(failure);
    const auto time =
        failure ? std::filesystem::file_time_type::min() : metaFile.last_write_time(failure);
    if (failure || !m_Cache.isEnabled())
    {
        return ReadGuid(metaFile.path());
    }
    entry.time = time.time_since_epoch().count();
    std::string path = metaFile.path().generic_string();
    const auto kept = m_Kept.find(path);
    const bool isSame =
        kept != m_Kept.end() && kept->second.size == entry.size && kept->second.time == entry.time;
    entry.guid = isSame ? kept->second.guid : ReadGuid(metaFile.path());
    // A file that has just been written may be written again within the same tick of the clock.
    using namespace std::chrono_literals;
    if (std::filesystem::file_time_type::clock::now() - time > 2s)
    {
        m_Found.emplace(std::move(path), entry);
    }
    return entry.guid;
}

void GuidIndex::Store() const
{
    if (!m_Cache.isEnabled() || m_Found == m_Kept)
    {
        return;
    }
    ByteWriter writer;
    writer.List(std::vector<std::pair<std::string, Entry>>(m_Found.begin(), m_Found.end()),
                [&](const auto& entry) { Transfer(writer, entry); });
    m_Cache.Store(m_Key, writer.bytes());
}

} // namespace limn

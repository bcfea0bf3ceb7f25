#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limn/base/FileCache.h>
#include <memory>
#include <string>
#include <string_view>

namespace limn
{

class WorkerProcess;

/// A file to import, as the importing function gets it.
struct ImportedFile
{
    std::filesystem::path path;
    std::string settings; ///< the settings of the .meta file that matter
    std::string_view bytes;
};

/// A kind of files and what imports them.
struct ImportKind
{
    const char* noun;    ///< names it in sentences: "model"
    const char* version; ///< must change whenever equal files give another result than before
    /// Does the work in a worker; it takes the request that ImportInWorker takes.
    std::string (*work)(std::string_view request);
};

/// Imports files with third-party libraries, which may crash, hang or take too much memory, and
/// caches the results by content.
class Importer
{
public:
    struct Options
    {
        /// The process whose workers import. If it is null, the caller's own process imports, and a
        /// crash of a library ends it.
        std::shared_ptr<WorkerProcess> process;
        std::filesystem::path cacheFolder; ///< empty = nothing is cached
        /// The most bytes that the cache may take; 0 = no limit.
        std::uintmax_t cacheLimit = std::uintmax_t{1} << 30;
        std::chrono::milliseconds timeLimit = std::chrono::seconds(60); ///< for one file
    };

    Importer() : Importer(Options()) {}
    explicit Importer(Options options);

    /// Returns what the kind's function makes of a file, or what it made of an equal file with
    /// equal settings.
    /// @param bytes  the file's content
    /// @throws AssetError naming the file, if the function throws or ends without an answer
    FileCache::Entry Import(const ImportKind& kind, const std::filesystem::path& file,
                            const std::string& settings, std::string_view bytes) const;

    const std::filesystem::path& cacheFolder() const { return m_Options.cacheFolder; }

private:
    Options m_Options;
    std::shared_ptr<const FileCache> m_Cache; ///< shared by all copies
};

/// Reads a file that is to be imported.
/// @throws AssetError  if it cannot be read, is empty, or is only a pointer of Git LFS
std::string ReadForImport(const ImportKind& kind, const std::filesystem::path& file);

namespace detail
{
std::string RunImport(std::string (*import)(const ImportedFile&), std::string_view request);
}

/// Calls `Import` in a worker. `Import` returns what becomes of an ImportedFile, or throws
/// AssetError.
template <std::string (*Import)(const ImportedFile&)>
std::string ImportInWorker(std::string_view request)
{
    return detail::RunImport(Import, request);
}

} // namespace limn

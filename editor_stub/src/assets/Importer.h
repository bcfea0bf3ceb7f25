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

/// A file that is to be imported, as the function that does so gets it.
struct ImportedFile
{
    std::filesystem::path path;
    std::string settings; ///< of the .meta file, as far as they matter
    std::string_view bytes;
};

/// A kind of files and what imports them.
struct ImportKind
{
    const char* noun;    ///< names it in sentences: "model"
    const char* version; ///< another one whenever equal files give something else than before
    /// Takes what ImportInWorker gives it.
    std::string (*work)(std::string_view request);
};

/// Calls `Import`, which returns what becomes of an ImportedFile or throws AssetError, in a worker.
template <std::string (*Import)(const ImportedFile&)>
std::string ImportInWorker(std::string_view request);

/// Imports files by libraries of other people, which may crash, hang or take too much memory, and
/// keeps what comes of it by content.
class Importer
{
public:
    struct Options
    {
        /// Its workers import. If it is null, the caller's own process does, and a crash of a
        /// library ends it.
        std::shared_ptr<WorkerProcess> process;
        std::filesystem::path cacheFolder; ///< empty = nothing is kept
        /// The bytes that all that is kept may take; 0 = no limit.
        std::uintmax_t cacheLimit = std::uintmax_t{1} << 30;
        std::chrono::milliseconds timeLimit = std::chrono::seconds(60); ///< of a file
    };

    Importer() : Importer(Options()) {}
    explicit Importer(Options options);

    /// Returns what the kind's function makes of a file, or has made of an equal one with equal
    /// settings.
    /// @param bytes  of the file
    /// @throws AssetError naming the file, as the function does, or where it ends without an answer
    FileCache::Entry Import(const ImportKind& kind, const std::filesystem::path& file,
                            const std::string& settings, std::string_view bytes) const;

    const std::filesystem::path& cacheFolder() const { return m_Options.cacheFolder; }

private:
    Options m_Options;
    std::shared_ptr<const FileCache> m_Cache; ///< of all copies
};

/// Reads a file that is to be imported.
/// @throws AssetError  if it cannot be read, is empty, or is a pointer of Git LFS in its place
std::string ReadForImport(const ImportKind& kind, const std::filesystem::path& file);

namespace detail
{
std::string RunImport(std::string (*import)(const ImportedFile&), std::string_view request);
}

template <std::string (*Import)(const ImportedFile&)>
std::string ImportInWorker(std::string_view request)
{
    return detail::RunImport(Import, request);
}

} // namespace limn

#include "assets/Importer.h"

#include <cstdio>
#include <cstdlib>
#include <limn/base/ByteStream.h>
#include <limn/base/Diagnostic.h>
#include <limn/base/ReadFile.h>
#include <limn/base/WorkerProcess.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limn
{

namespace
{

constexpr const char* k_ImportMagic = "limn import 1\n";

/// Returns equal names for equal kinds, settings and bytes. It is no defence against who wants
/// equal ones.
std::string ImportKey(const ImportKind& kind, const std::string& settings, std::string_view bytes)
{
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    ByteWriter head;
    head.Values(std::string(kind.version), settings, static_cast<std::uint64_t>(bytes.size()));
    XXH3_128bits_update(&state, head.bytes().data(), head.bytes().size());
    XXH3_128bits_update(&state, bytes.data(), bytes.size());
    const XXH128_hash_t hash = XXH3_128bits_digest(&state);
    char key[33];
    std::snprintf(key, sizeof(key), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return key;
}

std::string ReasonOfImportEnd(const ImportKind& kind, const WorkerAnswer& answer,
                              std::chrono::milliseconds limit)
{
    const std::string beginning = std::string("the ") + kind.noun + " cannot be read: ";
    switch (answer.ending)
    {
    case WorkerAnswer::Ending::OutOfTime:
        return beginning + "the importer takes longer than " + std::to_string(limit.count()) +
               " ms; make it smaller";
    case WorkerAnswer::Ending::NotStarted:
        return beginning + "no process for the importer can be started";
    default:
        return beginning +
               (answer.ending == WorkerAnswer::Ending::Signal
                    ? "the importer stopped on it: " + SignalText(answer.number)
                    : "the importer ended with exit code " + std::to_string(answer.number)) +
               "; the file may be damaged; export it again";
    }
}

void AbortImportForTest(const std::filesystem::path& file)
{
    const char* const name = std::getenv("LIMN_TEST_ABORT");
    if (name && *name && file.filename() == name)
    {
        std::abort();
    }
}

/// An answer ends with what it is.
enum class ImportResult : char
{
    Imported,
    Failed ///< diagnostics come before it
};

void TransferProblem(auto& stream, auto& problem)
{
    stream.Values(problem.file, problem.location.line, problem.location.column, problem.message);
}

std::string FailedImport(const std::vector<Diagnostic>& problems)
{
    ByteWriter writer;
    writer.List(problems, [&](const Diagnostic& problem) { TransferProblem(writer, problem); });
    writer.Value(ImportResult::Failed);
    return writer.bytes();
}

} // namespace

std::string detail::RunImport(std::string (*import)(const ImportedFile&), std::string_view request)
{
    ImportedFile file;
    std::string path;
    std::uint64_t size = 0;
    ByteReader reader(request);
    reader.Values(path, file.settings, size);
    file.path = path;
    file.bytes = request.substr(request.size() - static_cast<std::size_t>(size));
    const auto fail = [&](const std::string& message)
    {
        return FailedImport({{Severity::Error, file.path.generic_string(), {}, message}});
    };
    AbortImportForTest(file.path);
    try
    {
        std::string answer = import(file);
        answer += static_cast<char>(ImportResult::Imported);
        return answer;
    }
    catch (const AssetError& error)
    {
        return FailedImport(error.diagnostics());
    }
    catch (const std::bad_alloc&)
    {
        return fail("there is not enough memory to read it; make it smaller");
    }
    catch (const std::exception& error)
    {
        return fail(std::string("it cannot be read: ") + error.what());
    }
}

Importer::Importer(Options options)
    : m_Options(std::move(options)),
      m_Cache(std::make_shared<const FileCache>(m_Options.cacheFolder, ".limnimport", k_ImportMagic,
                                                m_Options.cacheLimit))
{
}

FileCache::Entry Importer::Import(const ImportKind& kind, const std::filesystem::path& file,
                                  const std::string& settings, std::string_view bytes) const
{
    const std::string key = m_Cache->isEnabled() ? ImportKey(kind, settings, bytes) : "";
    if (std::optional<FileCache::Entry> entry = m_Cache->Load(key))
    {
        m_Cache->Touch(key);
        return std::move(*entry);
    }
    ByteWriter head;
    head.Values(file.string(), settings, static_cast<std::uint64_t>(bytes.size()));
    std::string request = head.bytes();
    request += bytes;
    WorkerAnswer answer =
        m_Options.process
            ? m_Options.process->Run({kind.work, nullptr, m_Options.timeLimit}, request)
            : WorkerAnswer{WorkerAnswer::Ending::Answered, 0, kind.work(request)};
    if (answer.ending != WorkerAnswer::Ending::Answered || answer.bytes.empty())
    {
        throw AssetError(file.generic_string(), {},
                         ReasonOfImportEnd(kind, answer, m_Options.timeLimit));
    }
    const auto result = static_cast<ImportResult>(answer.bytes.back());
    answer.bytes.pop_back();
    if (result == ImportResult::Failed)
    {
        std::vector<Diagnostic> problems;
        ByteReader reader(answer.bytes);
        reader.List(problems, [&](Diagnostic& problem) { TransferProblem(reader, problem); });
        throw AssetError(std::move(problems));
    }
    m_Cache->Store(key, answer.bytes);
    const std::size_t size = answer.bytes.size();
    return {std::move(answer.bytes), 0, size};
}

std::string ReadForImport(const ImportKind& kind, const std::filesystem::path& file)
{
    std::string bytes = ReadFile(file, k_MaxDataBytes);
    if (bytes.starts_with("version https://git-lfs"))
    {
        throw AssetError(file.generic_string(), {},
                         std::string("this is a pointer of Git LFS in place of the ") + kind.noun +
                             "; run 'git lfs pull'");
    }
    if (bytes.empty())
    {
        throw AssetError(file.generic_string(), {},
                         std::string("the file is empty; a ") + kind.noun + " is expected");
    }
    return bytes;
}

} // namespace limn

#include "parser/CorpusFiles.h"
#include "Paths.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace limn::test
{

namespace
{

constexpr std::string_view k_Extension = ".shader";
constexpr std::string_view k_Expected = ".expected.shader";
constexpr std::string_view k_Diagnostics = ".diagnostics";

bool EndsWith(const std::string& text, std::string_view end)
{
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string Read(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::string> Lines(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

CorpusFile ReadFile(const std::filesystem::path& path)
{
    CorpusFile file;
    const std::string stem = path.string().substr(0, path.string().size() - k_Extension.size());
    file.name = std::filesystem::path(stem).lexically_relative(CorpusFolder()).generic_string();
    file.text = Read(path);
    const std::filesystem::path expected = stem + std::string(k_Expected);
    if (std::filesystem::exists(expected))
    {
        file.document = Read(expected);
    }
    file.diagnostics = Lines(Read(stem + std::string(k_Diagnostics)));
    return file;
}

} // namespace

bool CorpusFile::hasErrors() const
{
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const std::string& diagnostic)
                       { return diagnostic.find(": error: ") != std::string::npos; });
}

std::filesystem::path CorpusFolder()
{
    return SourcePath("tests/shaderlab/corpus");
}

const std::vector<CorpusFile>& CorpusFiles()
{
    static const std::vector<CorpusFile> files = []
    {
        std::vector<CorpusFile> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(CorpusFolder()))
        {
            const std::string path = entry.path().string();
            if (EndsWith(path, k_Extension) && !EndsWith(path, k_Expected))
            {
                found.push_back(ReadFile(entry.path()));
            }
        }
        std::sort(found.begin(), found.end(),
                  [](const CorpusFile& a, const CorpusFile& b) { return a.name < b.name; });
        return found;
    }();
    return files;
}

} // namespace limn::test

#include <limn/editor_stub/GltfMesh.h>

#include "gltf/Collector.h"
#include <algorithm>
#include <cstdio>
#include <limn/base/Diagnostic.h>
#include <limn/base/ReadFile.h>
#include <string_view>
#include <tiny_gltf.h>
#include <utility>

namespace limn
{

namespace
{

/// Returns the parser's complaint on one line. The place is taken out of a JSON parser's "[...]
/// parse error at line 3, column 7: what", and the name of the exception out of "[...] what".
AssetError ParseFailure(const std::filesystem::path& path, std::string error)
{
    while (!error.empty() && error.back() == '\n')
    {
        error.pop_back();
    }
    std::replace(error.begin(), error.end(), '\n', ' ');

    SourceLocation location;
    const std::size_t place = error.find("line ");
    int length = 0;
    if (place != std::string::npos && std::sscanf(error.c_str() + place, "line %d, column %d: %n",
                                                  &location.line, &location.column, &length) == 2)
    {
        error.erase(0, place + static_cast<std::size_t>(length));
    }
    else if (const std::size_t end = error.find("] "); error.starts_with('[') && end < error.size())
    {
        error.erase(0, end + 2);
    }
    return AssetError(path.string(), location, "the file is not glTF 2.0: " + error);
}

/// Pictures are no part of a mesh, so none is read and none that is missing matters.
bool SkipImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
               int, void*)
{
    return true;
}

/// The greatest depth into which the JSON parser and tinygltf may recurse. Real files have less
/// than ten levels.
constexpr int k_MaxLevels = 64;

/// The first bracket that is nested too deep; `text.size()` if none is.
std::size_t FindTooDeep(std::string_view text)
{
    int levels = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        if (c == '"')
        {
            for (++i; i < text.size() && text[i] != '"'; ++i)
            {
                i += text[i] == '\\' ? 1 : 0;
            }
        }
        if (c == ']' || c == '}')
        {
            levels = std::max(levels - 1, 0);
        }
        else if ((c == '[' || c == '{') && ++levels > k_MaxLevels)
        {
            return i;
        }
    }
    return text.size();
}

/// The JSON of a file: all of it, or the first chunk of the binary container. What is wrong with
/// the container is left for the parser to say.
std::string_view JsonOf(std::string_view file, bool isBinary)
{
    constexpr std::size_t lengthAt = 12;
    constexpr std::size_t headers = 20;
    if (!isBinary || file.size() < headers)
    {
        return isBinary ? std::string_view() : file;
    }
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        length |= std::size_t{static_cast<unsigned char>(file[lengthAt + i])} << (8 * i);
    }
    return file.substr(headers, length);
}

void CheckLevels(const std::filesystem::path& path, std::string_view file, bool isBinary)
{
    const std::string_view json = JsonOf(file, isBinary);
    const std::size_t at = FindTooDeep(json);
    if (at == json.size())
    {
        return;
    }
    const std::string_view before = json.substr(0, at);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const SourceLocation place{static_cast<int>(lines) + 1,
                               static_cast<int>(at - (before.rfind('\n') + 1)) + 1};
    throw AssetError(path.string(), isBinary ? SourceLocation{} : place,
                     "lists and objects are nested more than " + std::to_string(k_MaxLevels) +
                         " levels deep; glTF needs less than ten");
}

/// Reads the files that a glTF file names, and keeps what is wrong with the last one that it could
/// not read.
struct ReferredFiles
{
    FileRoots roots;
    const std::function<void(const std::filesystem::path&)>& reach;
    std::string problem;

    bool Read(const std::filesystem::path& path, std::vector<unsigned char>& bytes)
    {
        if (reach)
        {
            reach(path.lexically_normal());
        }
        FileContent content;
        content.problem = "it lies outside the folders that references may lead into";
        if (roots.Contains(path))
        {
            content = TryReadFile(path, k_MaxDataBytes);
        }
        bytes.assign(content.bytes.begin(), content.bytes.end());
        if (!content.isRead())
        {
            problem = "buffer '" + path.filename().string() + "': " + content.problem;
        }
        return content.isRead();
    }

    tinygltf::FsCallbacks Callbacks()
    {
        tinygltf::FsCallbacks callbacks{};
        // Whatever is wrong with the file beside this one: none of the working directory counts.
        callbacks.FileExists = [](const std::string&, void*)
        {
            return true;
        };
        callbacks.ExpandFilePath = [](const std::string& path, void*)
        {
            return path;
        };
        callbacks.ReadWholeFile =
            [](std::vector<unsigned char>* out, std::string*, const std::string& path, void* files)
        {
            return static_cast<ReferredFiles*>(files)->Read(path, *out);
        };
        callbacks.user_data = this;
        return callbacks;
    }
};

tinygltf::Model ParseFile(const std::filesystem::path& path, ReferredFiles files)
{
    const std::string bytes = ReadFile(path, k_MaxDataBytes);
    if (bytes.empty())
    {
        throw AssetError(path.string(), {}, "the file is empty; a glTF 2.0 file is expected");
    }
    const char* text = bytes.data();
    const auto length = static_cast<unsigned int>(bytes.size());
    const bool isBinary = std::string_view(text, bytes.size()).starts_with("glTF");

    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(SkipImage, nullptr);
    files.roots.Add(path.parent_path());
    parser.SetFsCallbacks(files.Callbacks());
    tinygltf::Model model;
    std::string error;
    std::string warning;
    const std::string folder = path.parent_path().string();
    CheckLevels(path, std::string_view(text, bytes.size()), isBinary);
    const bool parsed =
        isBinary ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                               reinterpret_cast<const unsigned char*>(text), length,
                                               folder)
                 : parser.LoadASCIIFromString(&model, &error, &warning, text, length, folder);
    if (!parsed)
    {
        // The parser's own words for a file that cannot be read.
        const bool isOfFile = error.find("File read error") != std::string::npos;
        throw isOfFile ? AssetError(path.string(), {}, files.problem) : ParseFailure(path, error);
    }
    return model;
}

std::vector<std::string> FileProblems(const tinygltf::Model& model)
{
    std::vector<std::string> problems;
    if (!model.asset.version.starts_with("2."))
    {
        problems.push_back("asset: the version is " + model.asset.version + "; limn reads 2.0");
    }
    for (const std::string& extension : model.extensionsRequired)
    {
        if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression")
        {
            problems.push_back("extension '" + extension +
                               "' is not supported; export without compression");
        }
    }
    return problems;
}

void ThrowIfAny(const std::filesystem::path& path, const std::vector<std::string>& problems)
{
    std::vector<Diagnostic> diagnostics;
    for (const std::string& problem : problems)
    {
        diagnostics.push_back({Severity::Error, path.string(), {}, problem});
    }
    if (!diagnostics.empty())
    {
        throw AssetError(std::move(diagnostics));
    }
}

} // namespace

std::shared_ptr<const Mesh>
LoadGltfMesh(const std::filesystem::path& path, const FileRoots& roots,
             const std::function<void(const std::filesystem::path&)>& reach)
{
    const tinygltf::Model model = ParseFile(path, {roots, reach, {}});
    ThrowIfAny(path, FileProblems(model));
    GltfCollector collector(model);
    collector.CollectAll();
    ThrowIfAny(path, collector.problems());
    MeshData data = collector.TakeMesh();
    if (data.triangles.empty())
    {
        throw AssetError(
            path.string(), {},
            "the file holds no triangles; at least one node of its scene must have a mesh");
    }
    return std::make_shared<const Mesh>(path.stem().string(), std::move(data));
}

} // namespace limn

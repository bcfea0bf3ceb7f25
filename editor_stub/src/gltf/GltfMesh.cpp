#include <limn/editor_stub/GltfMesh.h>

#include "gltf/Primitive.h"
#include <algorithm>
#include <cstdio>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <limn/base/ReadFile.h>
#include <limn/volume/AssetDiagnostics.h>
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
        const FileContent content =
            roots.Contains(path)
                ? TryReadFile(path, k_MaxDataBytes)
                : FileContent{"", "it lies outside the folders that references may lead into"};
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

void CheckFile(const tinygltf::Model& model, AssetDiagnostics& diagnostics)
{
    if (!model.asset.version.starts_with("2."))
    {
        diagnostics.Error({}, "asset: the version is " + model.asset.version + "; limn reads 2.0");
    }
    for (const std::string& extension : model.extensionsRequired)
    {
        if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression")
        {
            diagnostics.Error({}, "extension '" + extension +
                                      "' is not supported; export without compression");
        }
    }
}

glm::dmat4 LocalMatrix(const tinygltf::Node& node)
{
    if (node.matrix.size() == 16)
    {
        return glm::make_mat4(node.matrix.data());
    }
    const auto& t = node.translation;
    const auto& r = node.rotation;
    const auto& s = node.scale;
    glm::dmat4 matrix =
        r.size() == 4 ? glm::mat4_cast(glm::dquat(r[3], r[0], r[1], r[2])) : glm::dmat4(1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto i = static_cast<std::size_t>(axis);
        matrix[axis] *= s.size() == 3 ? s[i] : 1.0;
        matrix[3][axis] = t.size() == 3 ? t[i] : 0.0;
    }
    return matrix;
}

/// Puts `from` behind `to`; where only one of them has the array, the other's vertices get
/// `filler`.
template <typename Vector>
void Append(std::vector<Vector>& to, std::size_t vertexCount, const std::vector<Vector>& from,
            std::size_t addedCount, Vector filler)
{
    if (to.empty() && from.empty())
    {
        return;
    }
    to.resize(vertexCount, filler);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(vertexCount + addedCount, filler);
}

/// Walks a file's nodes and collects what they show. Parts that cannot be used become errors.
class GltfCollector
{
public:
    GltfCollector(const tinygltf::Model& model, AssetDiagnostics& diagnostics)
        : m_Model(model), m_Diagnostics(diagnostics), m_Visited(model.nodes.size(), false)
    {
    }

    /// Collects every mesh of the scene that the file shows, in limn's space.
    void CollectAll()
    {
        // limn's x axis points the other way.
        glm::dmat4 toLeftHanded(1.0);
        toLeftHanded[0][0] = -1.0;
        CollectNodes(toLeftHanded);
        for (std::size_t i = 0; m_Model.nodes.empty() && i < m_Model.meshes.size(); ++i)
        {
            CollectMesh(static_cast<int>(i), toLeftHanded);
        }
    }

    /// Returns one mesh of everything, with a sub-mesh for each part.
    MeshData TakeMesh()
    {
        MeshData all;
        const bool allHaveTangents =
            std::none_of(m_Parts.begin(), m_Parts.end(),
                         [](const MeshData& part) { return part.tangents.empty(); });
        for (const MeshData& part : m_Parts)
        {
            const std::size_t before = all.vertices.size();
            const std::size_t added = part.vertices.size();
            Append(all.colors, before, part.colors, added, glm::vec4(1.0f));
            Append(all.uv, before, part.uv, added, glm::vec2(0.0f));
            Append(all.uv2, before, part.uv2, added, glm::vec4(0.0f));
            all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
            all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
            if (allHaveTangents)
            {
                all.tangents.insert(all.tangents.end(), part.tangents.begin(), part.tangents.end());
            }
            all.subMeshes.push_back({static_cast<std::uint32_t>(all.triangles.size()),
                                     static_cast<std::uint32_t>(part.triangles.size())});
            for (const std::uint32_t index : part.triangles)
            {
                all.triangles.push_back(index + static_cast<std::uint32_t>(before));
            }
        }
        m_Parts.clear();
        return all;
    }

private:
    /// Returns the roots of the scene that the file shows first. Without scenes they are the nodes
    /// that have no parent.
    std::vector<int> Roots() const
    {
        if (!m_Model.scenes.empty())
        {
            const auto scene = static_cast<std::size_t>(std::max(m_Model.defaultScene, 0));
            return m_Model.scenes[std::min(scene, m_Model.scenes.size() - 1)].nodes;
        }
        std::vector<bool> isChild(m_Model.nodes.size(), false);
        for (const tinygltf::Node& node : m_Model.nodes)
        {
            for (const int child : node.children)
            {
                if (child >= 0 && static_cast<std::size_t>(child) < isChild.size())
                {
                    isChild[static_cast<std::size_t>(child)] = true;
                }
            }
        }
        std::vector<int> roots;
        for (std::size_t i = 0; i < isChild.size(); ++i)
        {
            if (!isChild[i])
            {
                roots.push_back(static_cast<int>(i));
            }
        }
        return roots;
    }

    /// Each node before its children, in the file's order. Not by recursion: a file may be deeper
    /// than the stack.
    void CollectNodes(const glm::dmat4& root)
    {
        struct Waiting
        {
            int node;
            glm::dmat4 parent;
        };
        std::vector<Waiting> waiting; // the next one last
        const auto add = [&waiting](const std::vector<int>& nodes, const glm::dmat4& parent)
        {
            for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            {
                waiting.push_back({*node, parent});
            }
        };
        add(Roots(), root);
        while (!waiting.empty())
        {
            const Waiting next = waiting.back();
            waiting.pop_back();
            if (const tinygltf::Node* node = Enter(next.node))
            {
                const glm::dmat4 matrix = next.parent * LocalMatrix(*node);
                if (node->mesh >= 0)
                {
                    CollectMesh(node->mesh, matrix);
                }
                add(node->children, matrix);
            }
        }
    }

    /// Returns a node. Returns null and adds an error if it does not exist or was entered before.
    const tinygltf::Node* Enter(int index)
    {
        const auto i = static_cast<std::size_t>(index);
        if (index < 0 || i >= m_Visited.size() || m_Visited[i])
        {
            m_Diagnostics.Error({},
                                "node " + std::to_string(index) +
                                    ": it does not exist or has two parents; nodes form a tree");
            return nullptr;
        }
        m_Visited[i] = true;
        return &m_Model.nodes[i];
    }

    void CollectMesh(int index, const glm::dmat4& matrix)
    {
        if (static_cast<std::size_t>(index) >= m_Model.meshes.size())
        {
            m_Diagnostics.Error({}, "mesh " + std::to_string(index) +
                                        ": it does not exist; the number of meshes is " +
                                        std::to_string(m_Model.meshes.size()));
            return;
        }
        const tinygltf::Mesh& mesh = m_Model.meshes[static_cast<std::size_t>(index)];
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i)
        {
            const std::string subject =
                "mesh '" + mesh.name + "' primitive " + std::to_string(i) + ": ";
            try
            {
                MeshData part = ReadGltfPrimitive(m_Model, mesh.primitives[i]);
                if (!part.triangles.empty())
                {
                    TransformPart(part, matrix);
                    for (const std::string& problem : MeshProblems(part))
                    {
                        m_Diagnostics.Error({}, subject + problem);
                    }
                    m_Parts.push_back(std::move(part));
                }
            }
            catch (const GltfProblem& problem)
            {
                m_Diagnostics.Error({}, subject + problem.what());
            }
        }
    }

    const tinygltf::Model& m_Model;
    AssetDiagnostics& m_Diagnostics;
    std::vector<bool> m_Visited;
    std::vector<MeshData> m_Parts;
};

} // namespace

std::shared_ptr<const Mesh>
LoadGltfMesh(const std::filesystem::path& path, const FileRoots& roots,
             const std::function<void(const std::filesystem::path&)>& reach)
{
    const tinygltf::Model model = ParseFile(path, {roots, reach, {}});
    AssetDiagnostics diagnostics(path.string());
    CheckFile(model, diagnostics);
    diagnostics.ThrowIfErrors();
    GltfCollector collector(model, diagnostics);
    collector.CollectAll();
    diagnostics.ThrowIfErrors();
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

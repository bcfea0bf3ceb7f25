#include "unity/ModelFile.h"

#include <algorithm>
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <charconv>
#include <cmath>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/matrix_decompose.hpp>
#include <limn/base/ModuleFile.h>
#include <limn/base/ReadFile.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limn
{

namespace
{

/// The functions of assimp that limn calls. They are not linked: assimp brings libdraco along,
/// which has functions of another version of tinygltf under the names of those that limn calls. And
/// only a scene with models needs it.
class Assimp
{
public:
    template <typename Function>
    static Function* Find(Function*, const char* name)
    {
        const void* symbol = OpenModule(LIMN_ASSIMP_LIBRARY, "assimp", false, name);
        if (symbol == nullptr)
        {
            throw AssetError(LIMN_ASSIMP_LIBRARY, {},
                             std::string("this is no assimp that limn knows; it lacks ") + name);
        }
        return reinterpret_cast<Function*>(const_cast<void*>(symbol));
    }
};
/// Each is looked for once.
#define LIMN_ASSIMP(name)                                                                          \
    (                                                                                              \
        []                                                                                         \
        {                                                                                          \
            static decltype(&name) const found = Assimp::Find(decltype(&name){}, #name);           \
            return found;                                                                          \
        }())

/// A link of the chain of nodes that assimp makes of an FBX node with pivots.
constexpr std::string_view k_Link = "_$AssimpFbx$_";

glm::dmat4 ToMatrix(const aiMatrix4x4& m)
{
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2,
            m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

/// The FBX node's chain T Roff Rp Rpre R Rpost' Rp' Soff Sp S Sp' in two parts. Unity's node has
/// its origin at the rotation's pivot; what is left over goes into vertices and children.
struct Chain
{
    glm::dmat4 node{1.0};
    glm::dmat4 rest{1.0};     ///< node * rest is the whole chain
    glm::dmat4 geometry{1.0}; ///< of the vertices alone
};

Chain ChainOf(const std::vector<const aiNode*>& links)
{
    glm::dmat4 node{1.0};
    glm::dmat4 whole{1.0};
    Chain chain;
    for (const aiNode* link : links)
    {
        const std::string_view name(link->mName.C_Str(), link->mName.length);
        const std::size_t at = name.rfind(k_Link);
        const std::string_view kind =
            at == std::string_view::npos ? std::string_view() : name.substr(at + k_Link.size());
        const glm::dmat4 matrix = ToMatrix(link->mTransformation);
        if (kind.starts_with("Geometric"))
        {
            chain.geometry = kind.ends_with("Inverse") ? chain.geometry : chain.geometry * matrix;
            continue;
        }
        whole = whole * matrix;
        const bool isLeftOver = kind == "RotationPivotInverse" || kind == "ScalingOffset" ||
                                kind == "ScalingPivot" || kind == "ScalingPivotInverse";
        node = isLeftOver ? node : node * matrix;
    }
    chain.node = node;
    chain.rest = glm::inverse(node) * whole;
    return chain;
}

/// A file's lengths and axes in Unity's: x is turned over.
class UnityAxes
{
public:
    explicit UnityAxes(double scale) : m_Scale(scale) {}

    glm::vec3 Position(const glm::dvec3& p) const
    {
        return glm::vec3(glm::dvec3(-p.x, p.y, p.z) * m_Scale);
    }
    static glm::vec3 Direction(const glm::dvec3& d)
    {
        const double length = glm::length(d);
        return length > 0.0 ? glm::vec3(glm::dvec3(-d.x, d.y, d.z) / length) : glm::vec3(0.0f);
    }
    void SetTransform(const glm::dmat4& matrix, ModelNode& node) const
    {
        glm::dvec3 scale;
        glm::dquat rotation;
        glm::dvec3 position;
        glm::dvec3 skew;
        glm::dvec4 perspective;
        if (glm::decompose(matrix, scale, rotation, position, skew, perspective))
        {
            node.position = Position(position);
            node.rotation = glm::quat(glm::dquat(rotation.w, rotation.x, -rotation.y, -rotation.z));
            node.scale = glm::vec3(scale);
        }
    }

private:
    double m_Scale;
};

double UnitOf(const aiScene& scene)
{
    double unit = 1.0;
    float narrow = 1.0f;
    if (scene.mMetaData != nullptr && !scene.mMetaData->Get("UnitScaleFactor", unit) &&
        scene.mMetaData->Get("UnitScaleFactor", narrow))
    {
        unit = static_cast<double>(narrow);
    }
    return unit;
}

/// Goes through the nodes of a scene of assimp's.
class ModelReader
{
public:
    ModelReader(const aiScene& scene, const ModelImport& import, bool isFbx)
        : m_Scene(scene),
          m_Axes((isFbx && import.useFileScale ? 0.01 * UnitOf(scene) : 1.0) *
                 static_cast<double>(import.globalScale))
    {
    }

    Model Read(const std::string& name)
    {
        for (unsigned i = 0; i < m_Scene.mNumMaterials; ++i)
        {
            AddMaterial(*m_Scene.mMaterials[i]);
        }
        m_Model.nodes.emplace_back().name = name;
        const aiNode& root = *m_Scene.mRootNode;
        AddMeshes(root, glm::dmat4(1.0), 0);
        for (unsigned i = 0; i < root.mNumChildren; ++i)
        {
            AddNode(*root.mChildren[i], 0, glm::dmat4(1.0));
        }
        return std::move(m_Model);
    }

private:
    void AddMaterial(const aiMaterial& material)
    {
        ModelMaterial& added = m_Model.materials.emplace_back();
        aiString name;
        if (LIMN_ASSIMP(aiGetMaterialString)(&material, AI_MATKEY_NAME, &name) == aiReturn_SUCCESS)
        {
            added.name = name.C_Str();
        }
        aiColor4D color;
        if (LIMN_ASSIMP(aiGetMaterialColor)(&material, AI_MATKEY_COLOR_DIFFUSE, &color) ==
            aiReturn_SUCCESS)
        {
            added.color = {color.r, color.g, color.b, color.a};
        }
    }

    /// @param parentRest  what is left over of the parent's chain
    void AddNode(const aiNode& first, std::size_t parent, const glm::dmat4& parentRest)
    {
        std::vector<const aiNode*> links{&first};
        while (std::string_view(links.back()->mName.C_Str()).find(k_Link) !=
                   std::string_view::npos &&
               links.back()->mNumChildren == 1)
        {
            links.push_back(links.back()->mChildren[0]);
        }
        const aiNode& last = *links.back();
        const Chain chain = ChainOf(links);
        const std::size_t index = m_Model.nodes.size();
        ModelNode& node = m_Model.nodes.emplace_back();
        node.name = last.mName.C_Str();
        node.parent = parent;
        m_Axes.SetTransform(parentRest * chain.node, node);
        AddMeshes(last, chain.rest * chain.geometry, index);
        for (unsigned i = 0; i < last.mNumChildren; ++i)
        {
            AddNode(*last.mChildren[i], index, chain.rest);
        }
    }

    void AddMeshes(const aiNode& source, const glm::dmat4& matrix, std::size_t index)
    {
        std::vector<unsigned> parts;
        for (unsigned i = 0; i < source.mNumMeshes; ++i)
        {
            const aiMesh& mesh = *m_Scene.mMeshes[source.mMeshes[i]];
            if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0 && mesh.mNumVertices > 0)
            {
                parts.push_back(source.mMeshes[i]);
            }
        }
        if (parts.empty())
        {
            return;
        }
        ModelNode& node = m_Model.nodes[index];
        for (const unsigned part : parts)
        {
            node.materials.push_back(
                m_Model.materials.at(m_Scene.mMeshes[part]->mMaterialIndex).name);
        }
        const auto known = m_Known.find(parts);
        if (known != m_Known.end())
        {
            node.mesh = known->second;
            return;
        }
        node.mesh = m_Known[parts] = m_Model.meshes.size();
        m_Model.meshes.push_back(std::make_shared<const Mesh>(node.name, Join(parts, matrix)));
    }

    MeshData Join(const std::vector<unsigned>& parts, const glm::dmat4& matrix) const
    {
        MeshData data;
        const glm::dmat3 directions = glm::transpose(glm::inverse(glm::dmat3(matrix)));
        const bool isMirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
        for (const unsigned part : parts)
        {
            const aiMesh& mesh = *m_Scene.mMeshes[part];
            const auto base = static_cast<std::uint32_t>(data.vertices.size());
            AppendVertices(mesh, matrix, directions, data);
            SubMesh subMesh;
            subMesh.indexStart = static_cast<std::uint32_t>(data.triangles.size());
            for (unsigned f = 0; f < mesh.mNumFaces; ++f)
            {
                const aiFace& face = mesh.mFaces[f];
                if (face.mNumIndices == 3)
                {
                    // x is turned over, and so is the winding.
                    const unsigned order[] = {0, isMirrored ? 1u : 2u, isMirrored ? 2u : 1u};
                    for (const unsigned corner : order)
                    {
                        data.triangles.push_back(base + face.mIndices[corner]);
                    }
                }
            }
            subMesh.indexCount =
                static_cast<std::uint32_t>(data.triangles.size()) - subMesh.indexStart;
            data.subMeshes.push_back(subMesh);
        }
        return data;
    }

    void AppendVertices(const aiMesh& mesh, const glm::dmat4& matrix, const glm::dmat3& directions,
                        MeshData& data) const
    {
        const auto vector = [](const aiVector3D& v)
        {
            return glm::dvec3(v.x, v.y, v.z);
        };
        for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        {
            data.vertices.push_back(
                m_Axes.Position(glm::dvec3(matrix * glm::dvec4(vector(mesh.mVertices[i]), 1.0))));
            data.normals.push_back(mesh.HasNormals()
                                       ? UnityAxes::Direction(directions * vector(mesh.mNormals[i]))
                                       : glm::vec3(0.0f, 1.0f, 0.0f));
            glm::vec4 tangent(1.0f, 0.0f, 0.0f, 1.0f);
            if (mesh.HasTangentsAndBitangents())
            {
                const glm::dvec3 normal = vector(mesh.mNormals[i]);
                const glm::dvec3 along = vector(mesh.mTangents[i]);
                const double side =
                    glm::dot(glm::cross(normal, along), vector(mesh.mBitangents[i]));
                tangent = glm::vec4(UnityAxes::Direction(glm::dmat3(matrix) * along),
                                    side < 0.0 ? 1.0f : -1.0f); // turned over with x
            }
            data.tangents.push_back(tangent);
            const auto uv = [&](unsigned set)
            {
                return mesh.HasTextureCoords(set)
                           ? glm::vec2(mesh.mTextureCoords[set][i].x, mesh.mTextureCoords[set][i].y)
                           : glm::vec2(0.0f);
            };
            data.uv.push_back(uv(0));
            data.uv2.emplace_back(uv(1), 0.0f, 0.0f);
            const aiColor4D color =
                mesh.HasVertexColors(0) ? mesh.mColors[0][i] : aiColor4D(1, 1, 1, 1);
            data.colors.emplace_back(color.r, color.g, color.b, color.a);
        }
    }

    const aiScene& m_Scene;
    UnityAxes m_Axes;
    Model m_Model;
    std::map<std::vector<unsigned>, std::size_t> m_Known; ///< meshes by what they are joined of
};

/// Unity makes the root of a node that is alone at the top.
void FoldTopNode(Model& model)
{
    const auto isTop = [](const ModelNode& node)
    {
        return node.parent == 0;
    };
    const bool isSingle = std::count_if(model.nodes.begin() + 1, model.nodes.end(), isTop) == 1;
    if (!isSingle || model.nodes.front().mesh)
    {
        return;
    }
    const std::string name = model.nodes.front().name;
    model.nodes.erase(model.nodes.begin());
    model.nodes.front().name = name;
    for (ModelNode& node : model.nodes)
    {
        node.parent -= node.parent > 0 ? 1 : 0;
    }
}

template <typename Names>
std::string NameOf(const Names& names, std::int64_t fileID)
{
    const auto found = names.find(fileID);
    return found == names.end() ? std::string() : found->second;
}

void ReadNames(const UnityNode& importer, ModelImport& import)
{
    const auto number = [](std::string_view text)
    {
        std::int64_t value = 0;
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    };
    for (const UnityNode entry : importer["fileIDToRecycleName"])
    {
        import.names[number(entry.key())] = entry.text();
    }
    for (const UnityNode entry : importer["internalIDToNameTable"])
    {
        const UnityNode first = entry["first"];
        if (first.begin() != first.end())
        {
            import.names[number((*first.begin()).text())] = entry["second"].text();
        }
    }
}

} // namespace

ModelImport ReadModelImport(const UnityNode& meta)
{
    ModelImport import;
    const UnityNode importer = meta["ModelImporter"];
    const auto number = [](const UnityNode& node, auto& value)
    {
        const std::string_view text = node.text();
        std::from_chars(text.data(), text.data() + text.size(), value);
    };
    const UnityNode meshes = importer["meshes"];
    int useFileScale = 1;
    int preserves = 0;
    int normals = 0;
    number(meshes["globalScale"], import.globalScale);
    number(meshes["useFileScale"], useFileScale);
    number(meshes["preserveHierarchy"], preserves);
    number(meshes["fileIdsGeneration"], import.fileIdsGeneration);
    number(importer["tangentSpace"]["normalImportMode"], normals);
    number(importer["tangentSpace"]["normalSmoothAngle"], import.normalSmoothAngle);
    import.useFileScale = useFileScale != 0;
    import.preserveHierarchy = preserves != 0;
    import.calculatesNormals = normals == 1;
    ReadNames(importer, import);
    for (const UnityNode entry : importer["externalObjects"])
    {
        import.materials[std::string(entry["first"]["name"].text())] =
            ReadUnityReference(entry["second"]);
    }
    return import;
}

Model LoadModel(const std::filesystem::path& path, const ModelImport& import)
{
    const std::string name = path.generic_string();
    const std::string bytes = ReadFile(path, k_MaxDataBytes);
    if (bytes.starts_with("version https://git-lfs"))
    {
        throw AssetError(name, {},
                         "this is a pointer of Git LFS in place of the model; run 'git lfs pull'");
    }
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool isFbx = extension == ".fbx";
    const std::unique_ptr<aiPropertyStore, void (*)(aiPropertyStore*)> settings(
        LIMN_ASSIMP(aiCreatePropertyStore)(), LIMN_ASSIMP(aiReleasePropertyStore));
    const auto setNumber = LIMN_ASSIMP(aiSetImportPropertyInteger);
    setNumber(settings.get(), AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 1);
    setNumber(settings.get(), AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
    LIMN_ASSIMP(aiSetImportPropertyFloat)
    (settings.get(), AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, import.normalSmoothAngle);
    unsigned steps = aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                     aiProcess_GenSmoothNormals | aiProcess_CalcTangentSpace;
    steps |= import.calculatesNormals ? aiProcess_RemoveComponent : 0u;
    const std::unique_ptr<const aiScene, void (*)(const aiScene*)> scene(
        isFbx ? LIMN_ASSIMP(aiImportFileFromMemoryWithProperties)(
                    bytes.data(), static_cast<unsigned>(bytes.size()), steps, extension.c_str() + 1,
                    settings.get())
              : LIMN_ASSIMP(aiImportFileExWithProperties)(path.string().c_str(), steps, nullptr,
                                                          settings.get()),
        LIMN_ASSIMP(aiReleaseImport));
    if (scene == nullptr || scene->mRootNode == nullptr)
    {
        throw AssetError(
            name, {}, std::string("the model cannot be read: ") + LIMN_ASSIMP(aiGetErrorString)());
    }
    Model model = [&]
    {
        try
        {
            return ModelReader(*scene, import, isFbx).Read(path.stem().string());
        }
        catch (const ContractError& error) // numbers of a mesh that are none
        {
            throw AssetError(name, {}, error.what());
        }
    }();
    model.import = import;
    if (!import.preserveHierarchy)
    {
        FoldTopNode(model);
    }
    return model;
}

std::int64_t HashedFileID(std::string_view text)
{
    return static_cast<std::int64_t>(XXH64(text.data(), text.size(), 0));
}

std::shared_ptr<const Mesh> Model::FindMesh(std::int64_t fileID) const
{
    const std::string name = NameOf(import.names, fileID);
    std::map<std::string, int> counts;
    for (const auto& mesh : meshes)
    {
        const std::string text =
            "Type:Mesh->" + mesh->name() + std::to_string(counts[mesh->name()]++);
        if (name.empty() ? HashedFileID(text) == fileID : mesh->name() == name)
        {
            return mesh;
        }
    }
    // A folded node gave its mesh its own name, and the root has the file's.
    return !name.empty() && meshes.size() == 1 ? meshes.front() : nullptr;
}

const ModelMaterial* Model::FindMaterial(std::int64_t fileID) const
{
    const std::string name = NameOf(import.names, fileID);
    const auto found = std::ranges::find_if(
        materials,
        [&](const ModelMaterial& material)
        {
            return name.empty() ? HashedFileID("Type:Material->" + material.name + "0") == fileID
                                : material.name == name;
        });
    return found == materials.end() ? nullptr : &*found;
}

namespace
{

/// Writes the objects of a model as a prefab does.
class PrefabWriter
{
public:
    PrefabWriter(const Model& model, const std::string& guid) : m_Model(model), m_Guid(guid) {}

    std::string Write()
    {
        m_Text = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";
        for (std::size_t i = 0; i < m_Model.nodes.size(); ++i)
        {
            m_Paths.push_back(i == 0
                                  ? "//RootNode/root"
                                  : m_Paths[m_Model.nodes[i].parent] + "/" + m_Model.nodes[i].name);
        }
        for (std::size_t i = 0; i < m_Model.nodes.size(); ++i)
        {
            WriteNode(i);
        }
        return std::move(m_Text);
    }

private:
    /// The id of a node's GameObject or of one of its components.
    std::int64_t IdOf(std::size_t node, UnityClass classID, std::string_view name) const
    {
        const std::string wanted = node == 0 ? "//RootNode" : m_Model.nodes[node].name;
        const std::int64_t first = static_cast<std::int64_t>(classID) * 100'000;
        const auto begin = m_Model.import.names.lower_bound(first);
        const auto end = m_Model.import.names.lower_bound(first + 100'000);
        const auto found =
            std::find_if(begin, end, [&](const auto& entry) { return entry.second == wanted; });
        if (found != end)
        {
            return found->first;
        }
        return HashedFileID(
            "Type:" + std::string(name) + "->" + m_Paths[node] +
            (classID == UnityClass::GameObject ? "0" : "/" + std::string(name) + "0"));
    }

    std::int64_t MeshId(std::size_t mesh) const
    {
        const std::string& name = m_Model.meshes[mesh]->name();
        for (const auto& [id, known] : m_Model.import.names)
        {
            if (id / 100'000 == static_cast<int>(UnityClass::Mesh) && known == name)
            {
                return id;
            }
        }
        return HashedFileID("Type:Mesh->" + name + "0");
    }

    void Begin(UnityClass classID, std::int64_t id, const char* name)
    {
        m_Text += "--- !u!" + std::to_string(static_cast<int>(classID)) + " &" +
                  std::to_string(id) + "\n" + name + ":\n";
    }
    static std::string Number(float value)
    {
        char text[40];
        const auto [end, error] = std::to_chars(text, text + sizeof(text), value);
        return std::string(text, end);
    }
    static std::string Vector(const glm::vec3& v)
    {
        return "{x: " + Number(v.x) + ", y: " + Number(v.y) + ", z: " + Number(v.z) + "}";
    }
    static std::string Own(std::int64_t id) { return "{fileID: " + std::to_string(id) + "}"; }
    /// A name may hold anything.
    static std::string Quoted(const std::string& name)
    {
        std::string text = "'";
        for (const char letter : name)
        {
            text += letter == '\n' ? ' ' : letter;
            text += letter == '\'' ? "'" : "";
        }
        return text + "'";
    }

    void WriteNode(std::size_t index)
    {
        const ModelNode& node = m_Model.nodes[index];
        const std::int64_t object = IdOf(index, UnityClass::GameObject, "GameObject");
        const std::int64_t transform = IdOf(index, UnityClass::Transform, "Transform");
        Begin(UnityClass::GameObject, object, "GameObject");
        m_Text += "  m_Layer: 0\n  m_Name: " + Quoted(node.name) + "\n  m_IsActive: 1\n";
        Begin(UnityClass::Transform, transform, "Transform");
        m_Text +=
            "  m_GameObject: " + Own(object) +
            "\n  m_LocalRotation: {x: " + Number(node.rotation.x) +
            ", y: " + Number(node.rotation.y) + ", z: " + Number(node.rotation.z) +
            ", w: " + Number(node.rotation.w) + "}\n  m_LocalPosition: " + Vector(node.position) +
            "\n  m_LocalScale: " + Vector(node.scale) + "\n  m_Father: " +
            Own(index == 0 ? 0 : IdOf(node.parent, UnityClass::Transform, "Transform")) + "\n";
        if (node.mesh)
        {
            WriteRenderer(index, object);
        }
    }

    void WriteRenderer(std::size_t index, std::int64_t object)
    {
        const ModelNode& node = m_Model.nodes[index];
        Begin(UnityClass::MeshFilter, IdOf(index, UnityClass::MeshFilter, "MeshFilter"),
              "MeshFilter");
        m_Text += "  m_GameObject: " + Own(object) +
                  "\n  m_Mesh: {fileID: " + std::to_string(MeshId(*node.mesh)) +
                  ", guid: " + m_Guid + ", type: 3}\n";
        Begin(UnityClass::MeshRenderer, IdOf(index, UnityClass::MeshRenderer, "MeshRenderer"),
              "MeshRenderer");
        m_Text += "  m_GameObject: " + Own(object) +
                  "\n  m_Enabled: 1\n  m_RenderingLayerMask: 1\n  m_Materials:\n";
        for (const std::string& material : node.materials)
        {
            const auto remapped = m_Model.import.materials.find(material);
            const std::int64_t id = remapped != m_Model.import.materials.end()
                                        ? remapped->second.fileID
                                        : HashedFileID("Type:Material->" + material + "0");
            m_Text +=
                "  - {fileID: " + std::to_string(id) + ", guid: " +
                (remapped != m_Model.import.materials.end() ? remapped->second.guid : m_Guid) +
                ", type: 3}\n";
        }
    }

    const Model& m_Model;
    const std::string& m_Guid;
    std::vector<std::string> m_Paths; ///< by node
    std::string m_Text;
};

} // namespace

std::string PrefabTextOf(const Model& model, const std::string& guid)
{
    return PrefabWriter(model, guid).Write();
}

} // namespace limn

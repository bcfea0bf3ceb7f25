#include "models/AssimpModel.h"

#include "models/MikkTangents.h"

#include <algorithm>
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/matrix_decompose.hpp>
#include <limn/base/Case.h>
#include <limn/base/ModuleFile.h>
#include <stdexcept>

namespace limn
{

namespace
{

/// Finds a function of assimp that limn calls. They are not linked: assimp brings libdraco along,
/// which has functions of another version of tinygltf under the names of those that limn calls. And
/// only a scene with models needs it.
template <typename Function>
Function* Find(Function*, const char* name)
{
    return reinterpret_cast<Function*>(const_cast<void*>(FindInAssimp(LIMN_ASSIMP_LIBRARY, name)));
}
/// Each is looked for once.
#define LIMN_ASSIMP(name)                                                                          \
    (                                                                                              \
        []                                                                                         \
        {                                                                                          \
            static decltype(&name) const found = Find(decltype(&name){}, #name);                   \
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
    /// @param turn  turns the file's vertices and nodes before that
    UnityAxes(double scale, const glm::dmat3& turn) : m_Scale(scale), m_Turn(turn) {}

    glm::vec3 Position(const glm::dvec3& position) const { return Scaled(m_Turn * position); }
    glm::vec3 Direction(const glm::dvec3& direction) const
    {
        const glm::dvec3 d = m_Turn * direction;
        const double length = glm::length(d);
        return length > 0.0 ? glm::vec3(glm::dvec3(-d.x, d.y, d.z) / length) : glm::vec3(0.0f);
    }
    /// Returns the matrix that does in Unity's space what `matrix` does in the file's.
    glm::dmat4 Matrix(const glm::dmat4& matrix) const
    {
        const glm::dmat4 axes =
            glm::scale(glm::dmat4(1.0), glm::dvec3(-m_Scale, m_Scale, m_Scale)) *
            glm::dmat4(m_Turn);
        return axes * matrix * glm::inverse(axes);
    }
    void SetTransform(const glm::dmat4& matrix, ModelNode& node) const
    {
        glm::dvec3 scale;
        glm::dquat rotation;
        glm::dvec3 position;
        glm::dvec3 skew;
        glm::dvec4 perspective;
        const glm::dmat4 turned = glm::dmat4(m_Turn) * matrix * glm::dmat4(glm::transpose(m_Turn));
        if (glm::decompose(turned, scale, rotation, position, skew, perspective))
        {
            node.position = Scaled(position);
            node.rotation = glm::quat(glm::dquat(rotation.w, rotation.x, -rotation.y, -rotation.z));
            node.scale = glm::vec3(scale);
        }
    }

private:
    glm::vec3 Scaled(const glm::dvec3& p) const
    {
        return glm::vec3(glm::dvec3(-p.x, p.y, p.z) * m_Scale);
    }

    double m_Scale;
    glm::dmat3 m_Turn;
};

/// Returns the rotation that turns an FBX file's axes so that y is up, as Unity has it. A file that
/// has y up already is left as it is, and so is one that has other axes than right-handed ones.
glm::dmat3 TurnOf(const aiScene& scene)
{
    glm::dmat3 rows(0.0);
    constexpr std::pair<const char*, const char*> k_Names[] = {
        {"CoordAxis", "CoordAxisSign"}, {"UpAxis", "UpAxisSign"}, {"FrontAxis", "FrontAxisSign"}};
    for (int i = 0; i < 3; ++i)
    {
        int axis = -1;
        int sign = 0;
        const auto& [axisName, signName] = k_Names[i];
        if (scene.mMetaData == nullptr || !scene.mMetaData->Get(axisName, axis) ||
            !scene.mMetaData->Get(signName, sign) || axis < 0 || axis > 2)
        {
            return glm::dmat3(1.0);
        }
        rows[i][axis] = sign < 0 ? -1.0 : 1.0;
    }
    const bool isYUp = rows[1][1] > 0.0;
    return isYUp || glm::determinant(rows) < 0.5 ? glm::dmat3(1.0) : glm::transpose(rows);
}

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
          m_Import(import),
          m_Turn(isFbx ? TurnOf(scene) : glm::dmat3(1.0)),
          m_Axes((isFbx && import.useFileScale ? 0.01 * UnitOf(scene) : 1.0) *
                     static_cast<double>(import.globalScale),
                 import.bakesAxisConversion ? m_Turn : glm::dmat3(1.0))
    {
    }

    ModelContent Read(const std::string& name)
    {
        for (unsigned i = 0; i < m_Scene.mNumMaterials; ++i)
        {
            AddMaterial(*m_Scene.mMaterials[i]);
        }
        m_Model.nodes.emplace_back().name = name;
        m_Rests[m_Scene.mRootNode->mName.C_Str()] = glm::dmat4(1.0);
        const aiNode& root = *m_Scene.mRootNode;
        AddMeshes(root, glm::dmat4(1.0), 0);
        for (unsigned i = 0; i < root.mNumChildren; ++i)
        {
            AddNode(*root.mChildren[i], 0,
                    m_Import.bakesAxisConversion ? glm::dmat4(1.0) : glm::dmat4(m_Turn));
        }
        PlaceBones();
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
        aiString texture;
        if (LIMN_ASSIMP(aiGetMaterialString)(&material, AI_MATKEY_TEXTURE_DIFFUSE(0), &texture) ==
            aiReturn_SUCCESS)
        {
            const std::string file = texture.C_Str(); // it may be a path of another machine
            added.texture =
                std::filesystem::path(file.substr(file.find_last_of("/\\") + 1)).stem().string();
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
        m_Rests.try_emplace(node.name, chain.rest);
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
        ModelContent::NamedMesh mesh{node.name, Join(parts, matrix), JoinSkins(parts, matrix)};
        if (mesh.data.tangents.empty() && m_Import.tangents != ModelTangents::None)
        {
            const std::vector<std::uint32_t> copied = ComputeMikkTangents(mesh.data);
            for (std::size_t i = 0; !mesh.skin.isEmpty() && i < copied.size(); ++i)
            {
                const BoneWeights weights = mesh.skin.weights[copied[i]];
                mesh.skin.weights.push_back(weights);
            }
        }
        m_Model.meshes.push_back(std::move(mesh));
    }

    /// The bind poses lack what is left over of their bones' chains: those may not be read yet.
    MeshSkin JoinSkins(const std::vector<unsigned>& parts, const glm::dmat4& matrix) const
    {
        MeshSkin skin;
        std::map<std::string, std::uint32_t> bones;
        std::size_t first = 0;
        for (const unsigned part : parts)
        {
            const aiMesh& mesh = *m_Scene.mMeshes[part];
            skin.weights.resize(first + mesh.mNumVertices);
            for (unsigned b = 0; b < mesh.mNumBones; ++b)
            {
                const aiBone& bone = *mesh.mBones[b];
                const auto [known, isNew] = bones.try_emplace(
                    bone.mName.C_Str(), static_cast<std::uint32_t>(skin.bones.size()));
                if (isNew)
                {
                    skin.bones.push_back(known->first);
                    skin.bindPoses.emplace_back(
                        m_Axes.Matrix(ToMatrix(bone.mOffsetMatrix) * glm::inverse(matrix)));
                }
                for (unsigned w = 0; w < bone.mNumWeights; ++w)
                {
                    const aiVertexWeight& weight = bone.mWeights[w];
                    RequireIndex(weight.mVertexId, mesh);
                    AddWeight(skin.weights[first + weight.mVertexId],
                              {known->second, weight.mWeight});
                }
            }
            first = skin.weights.size();
        }
        std::ranges::for_each(skin.weights, Normalize);
        return skin.bones.empty() ? MeshSkin() : skin;
    }

    /// Keeps the largest weights of a vertex.
    static void AddWeight(BoneWeights& weights, const BoneWeight& added)
    {
        BoneWeight& least = *std::ranges::min_element(weights, {}, &BoneWeight::weight);
        least = added.weight > least.weight ? added : least;
    }

    void PlaceBones()
    {
        for (ModelContent::NamedMesh& mesh : m_Model.meshes)
        {
            for (std::size_t i = 0; i < mesh.skin.bones.size(); ++i)
            {
                const auto rest = m_Rests.find(mesh.skin.bones[i]);
                glm::mat4& pose = mesh.skin.bindPoses[i];
                pose = rest != m_Rests.end()
                           ? glm::mat4(m_Axes.Matrix(rest->second) * glm::dmat4(pose))
                           : pose;
            }
        }
    }

    /// The arrays that a joined mesh has: those of any part.
    struct Channels
    {
        bool hasColors = false;
        bool hasTangents = true; ///< in every part
        unsigned uvSets = 1;
    };
    static constexpr unsigned k_MostUvSets = 7;

    Channels ChannelsOf(const std::vector<unsigned>& parts) const
    {
        Channels channels;
        channels.hasTangents = m_Import.tangents == ModelTangents::Import;
        for (const unsigned part : parts)
        {
            const aiMesh& mesh = *m_Scene.mMeshes[part];
            channels.hasColors |= mesh.HasVertexColors(0);
            channels.hasTangents &= mesh.HasTangentsAndBitangents();
            for (unsigned set = 0; set < k_MostUvSets; ++set)
            {
                channels.uvSets = mesh.HasTextureCoords(set) ? std::max(channels.uvSets, set + 1)
                                                             : channels.uvSets;
            }
        }
        channels.uvSets = m_Import.swapUVChannels ? std::max(channels.uvSets, 2u) : channels.uvSets;
        return channels;
    }

    MeshData Join(const std::vector<unsigned>& parts, const glm::dmat4& matrix) const
    {
        MeshData data;
        const Channels channels = ChannelsOf(parts);
        const bool isMirrored = glm::determinant(glm::dmat3(matrix)) < 0.0;
        for (const unsigned part : parts)
        {
            const aiMesh& mesh = *m_Scene.mMeshes[part];
            const auto base = static_cast<std::uint32_t>(data.vertices.size());
            AppendVertices(mesh, matrix, channels, data);
            const auto start = static_cast<std::uint32_t>(data.triangles.size());
            for (unsigned f = 0; f < mesh.mNumFaces; ++f)
            {
                const aiFace& face = mesh.mFaces[f];
                if (face.mNumIndices == 3)
                {
                    // x is turned over, and so is the winding.
                    const unsigned order[] = {0, isMirrored ? 1u : 2u, isMirrored ? 2u : 1u};
                    for (const unsigned corner : order)
                    {
                        RequireIndex(face.mIndices[corner], mesh);
                        data.triangles.push_back(base + face.mIndices[corner]);
                    }
                }
            }
            data.subMeshes.push_back(
                {start, static_cast<std::uint32_t>(data.triangles.size()) - start});
        }
        return data;
    }

    static void RequireIndex(unsigned index, const aiMesh& mesh)
    {
        if (index >= mesh.mNumVertices)
        {
            throw std::runtime_error("a triangle has a vertex that the mesh does not have");
        }
    }

    void AppendVertices(const aiMesh& mesh, const glm::dmat4& matrix, const Channels& channels,
                        MeshData& data) const
    {
        const glm::dmat3 directions = glm::transpose(glm::inverse(glm::dmat3(matrix)));
        const auto vector = [](const aiVector3D& v)
        {
            return glm::dvec3(v.x, v.y, v.z);
        };
        for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        {
            data.vertices.push_back(
                m_Axes.Position(glm::dvec3(matrix * glm::dvec4(vector(mesh.mVertices[i]), 1.0))));
            data.normals.push_back(mesh.HasNormals()
                                       ? m_Axes.Direction(directions * vector(mesh.mNormals[i]))
                                       : glm::vec3(0.0f, 1.0f, 0.0f));
            if (channels.hasTangents)
            {
                const glm::dvec3 normal = vector(mesh.mNormals[i]);
                const glm::dvec3 along = vector(mesh.mTangents[i]);
                const double side =
                    glm::dot(glm::cross(normal, along), vector(mesh.mBitangents[i]));
                data.tangents.emplace_back(m_Axes.Direction(glm::dmat3(matrix) * along),
                                           side < 0.0 ? 1.0f : -1.0f); // turned over with x
            }
            if (channels.hasColors)
            {
                const aiColor4D color =
                    mesh.HasVertexColors(0) ? mesh.mColors[0][i] : aiColor4D(1, 1, 1, 1);
                data.colors.emplace_back(color.r, color.g, color.b, color.a);
            }
            AppendUv(mesh, i, channels, data);
        }
    }

    void AppendUv(const aiMesh& mesh, unsigned vertex, const Channels& channels,
                  MeshData& data) const
    {
        std::vector<glm::vec4>* const others[] = {&data.uv2, &data.uv3, &data.uv4,
                                                  &data.uv5, &data.uv6, &data.uv7};
        for (unsigned set = 0; set < channels.uvSets; ++set)
        {
            const unsigned source = m_Import.swapUVChannels && set < 2 ? 1 - set : set;
            glm::vec4 uv(0.0f);
            if (mesh.HasTextureCoords(source))
            {
                const aiVector3D& from = mesh.mTextureCoords[source][vertex];
                uv = glm::vec4(from.x, from.y, 0.0f, 0.0f);
            }
            if (set == 0)
            {
                data.uv.emplace_back(uv);
            }
            else
            {
                others[set - 1]->push_back(uv);
            }
        }
    }

    const aiScene& m_Scene;
    const ModelImport& m_Import;
    const glm::dmat3 m_Turn; ///< turns the file's axes
    UnityAxes m_Axes;
    ModelContent m_Model;
    std::map<std::vector<unsigned>, std::size_t> m_Known; ///< meshes by what they are joined of
    std::map<std::string, glm::dmat4> m_Rests; ///< what is left over of the nodes' chains
};

/// Unity makes the root of a node that is alone at the top.
void FoldTopNode(ModelContent& model)
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

} // namespace

const void* FindInAssimp(const std::filesystem::path& library, const char* function)
{
    const auto refuse = [&](const std::string& why)
    {
        throw AssetError(library.generic_string(), {},
                         "no model can be read: " + why +
                             "; assimp, the library that reads them, belongs here (Debian: apt "
                             "install libassimp5)");
    };
    const void* symbol = nullptr;
    try
    {
        symbol = OpenModule(library, "assimp", false, function);
    }
    catch (const AssetError& error)
    {
        refuse(error.diagnostics().front().message);
    }
    if (symbol == nullptr)
    {
        refuse(std::string("this is no assimp that limn knows; it lacks ") + function);
    }
    return symbol;
}

ModelContent ReadByAssimp(const std::filesystem::path& path, std::string_view bytes,
                          const std::string& name, const ModelImport& import)
{
    const std::string extension = ToLower(path.extension().string());
    const bool isFbx = extension == ".fbx";
    const std::unique_ptr<aiPropertyStore, void (*)(aiPropertyStore*)> settings(
        LIMN_ASSIMP(aiCreatePropertyStore)(), LIMN_ASSIMP(aiReleasePropertyStore));
    const auto setNumber = LIMN_ASSIMP(aiSetImportPropertyInteger);
    setNumber(settings.get(), AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, 1);
    setNumber(settings.get(), AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
    LIMN_ASSIMP(aiSetImportPropertyFloat)
    (settings.get(), AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, import.normalSmoothAngle);
    unsigned steps =
        aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_GenSmoothNormals;
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
        throw AssetError(path.generic_string(), {},
                         std::string("the model cannot be read: ") +
                             LIMN_ASSIMP(aiGetErrorString)());
    }
    ModelContent model = ModelReader(*scene, import, isFbx).Read(name);
    if (!import.preserveHierarchy)
    {
        FoldTopNode(model);
    }
    return model;
}

} // namespace limn

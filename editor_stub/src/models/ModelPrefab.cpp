#include "console/Texts.h"
#include "models/ModelFile.h"

#include <algorithm>

namespace limn
{

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
        SetIds();
        for (std::size_t i = 0; i < m_Model.nodes.size(); ++i)
        {
            WriteNode(i);
        }
        return std::move(m_Text);
    }

private:
    /// Sets the ids of the nodes' objects and of the meshes. Several may have one name, and Unity
    /// numbers them.
    void SetIds()
    {
        for (std::size_t i = 0; i < m_Model.nodes.size(); ++i)
        {
            const std::string& name = i == 0 ? k_RootName : m_Model.nodes[i].name;
            for (const UnityClass classID : ClassesOf(m_Model.nodes[i]))
            {
                const std::string text =
                    "Type:" + NameOf(classID) + "->" + m_Paths[i] +
                    (classID == UnityClass::GameObject ? "" : "/" + NameOf(classID));
                m_Ids[{i, classID}] = NewId(classID, name, text);
            }
        }
        for (const auto& mesh : m_Model.meshes)
        {
            m_MeshIds.push_back(
                NewId(UnityClass::Mesh, mesh->name(), "Type:Mesh->" + mesh->name()));
        }
    }

    std::vector<UnityClass> ClassesOf(const ModelNode& node) const
    {
        std::vector<UnityClass> classes{UnityClass::GameObject, UnityClass::Transform};
        if (node.mesh && m_Model.skins[*node.mesh].isEmpty())
        {
            classes.insert(classes.end(), {UnityClass::MeshFilter, UnityClass::MeshRenderer});
        }
        else if (node.mesh)
        {
            classes.push_back(UnityClass::SkinnedMeshRenderer);
        }
        return classes;
    }

    /// Returns the id of the next object of this name: that of the model's table, or else a hash.
    /// @param text  what is hashed, without the number
    std::int64_t NewId(UnityClass classID, const std::string& name, const std::string& text)
    {
        int left = m_Counts[NameOf(classID) + "/" + name]++; // objects of this name before it
        const std::int64_t first = static_cast<std::int64_t>(classID) * 100'000;
        for (auto known = m_Model.import.names.lower_bound(first);
             known != m_Model.import.names.lower_bound(first + 100'000); ++known)
        {
            if (known->second == name && left-- == 0)
            {
                return known->first;
            }
        }
        return HashedFileID(text + std::to_string(m_Counts[text]++));
    }

    std::int64_t IdOf(std::size_t node, UnityClass classID) const
    {
        return m_Ids.at({node, classID});
    }
    std::int64_t MeshId(std::size_t mesh) const { return m_MeshIds.at(mesh); }

    void Begin(UnityClass classID, std::int64_t id)
    {
        m_Text += "--- !u!" + std::to_string(static_cast<int>(classID)) + " &" +
                  std::to_string(id) + "\n" + NameOf(classID) + ":\n";
    }
    void BeginComponent(std::size_t node, UnityClass classID)
    {
        Begin(classID, IdOf(node, classID));
    }
    /// The id of the Transform of the node that is a bone; 0 if there is none.
    std::int64_t BoneId(const std::string& bone) const
    {
        const auto found = std::ranges::find(m_Model.nodes, bone, &ModelNode::name);
        const auto index = static_cast<std::size_t>(found - m_Model.nodes.begin());
        return found == m_Model.nodes.end() ? 0 : IdOf(index, UnityClass::Transform);
    }
    static std::string Number(float value) { return NumberText(static_cast<double>(value)); }
    static std::string Vector(const glm::vec3& v)
    {
        return "{x: " + Number(v.x) + ", y: " + Number(v.y) + ", z: " + Number(v.z) + "}";
    }
    static std::string Own(std::int64_t id) { return "{fileID: " + std::to_string(id) + "}"; }
    /// A name may hold anything.
    static std::string Quoted(const std::string& name)
    {
        return "'" + Replaced(Replaced(name, "\n", " "), "'", "''") + "'";
    }

    void WriteNode(std::size_t index)
    {
        const ModelNode& node = m_Model.nodes[index];
        const std::int64_t object = IdOf(index, UnityClass::GameObject);
        const std::int64_t transform = IdOf(index, UnityClass::Transform);
        Begin(UnityClass::GameObject, object);
        m_Text += "  m_Layer: 0\n  m_Name: " + Quoted(node.name) + "\n  m_IsActive: 1\n";
        Begin(UnityClass::Transform, transform);
        m_Text +=
            "  m_GameObject: " + Own(object) +
            "\n  m_LocalRotation: {x: " + Number(node.rotation.x) +
            ", y: " + Number(node.rotation.y) + ", z: " + Number(node.rotation.z) +
            ", w: " + Number(node.rotation.w) + "}\n  m_LocalPosition: " + Vector(node.position) +
            "\n  m_LocalScale: " + Vector(node.scale) +
            "\n  m_Father: " + Own(index == 0 ? 0 : IdOf(node.parent, UnityClass::Transform)) +
            "\n";
        if (node.mesh)
        {
            WriteRenderer(index, object);
        }
    }

    void WriteRenderer(std::size_t index, std::int64_t object)
    {
        const ModelNode& node = m_Model.nodes[index];
        const MeshSkin& skin = m_Model.skins[*node.mesh];
        const std::string mesh = "  m_GameObject: " + Own(object) +
                                 "\n  m_Mesh: {fileID: " + std::to_string(MeshId(*node.mesh)) +
                                 ", guid: " + m_Guid + ", type: 3}\n";
        if (skin.isEmpty())
        {
            BeginComponent(index, UnityClass::MeshFilter);
            m_Text += mesh;
            BeginComponent(index, UnityClass::MeshRenderer);
            m_Text += "  m_GameObject: " + Own(object) + "\n";
        }
        else
        {
            BeginComponent(index, UnityClass::SkinnedMeshRenderer);
            m_Text += mesh + "  m_Bones:\n";
            for (const std::string& bone : skin.bones)
            {
                m_Text += "  - " + Own(BoneId(bone)) + "\n";
            }
        }
        m_Text += "  m_Enabled: 1\n  m_RenderingLayerMask: 1\n  m_Materials:\n";
        for (const std::string& material : node.materials)
        {
            const auto found = m_Model.import.materials.find(material);
            const UnityReference used =
                found != m_Model.import.materials.end()
                    ? found->second
                    : UnityReference{HashedFileID("Type:Material->" + material + "0"), m_Guid};
            m_Text += "  - {fileID: " + std::to_string(used.fileID) + ", guid: " + used.guid +
                      ", type: 3}\n";
        }
    }

    const Model& m_Model;
    const std::string& m_Guid;
    const std::string k_RootName = "//RootNode";
    std::vector<std::string> m_Paths;                                 ///< by node
    std::map<std::pair<std::size_t, UnityClass>, std::int64_t> m_Ids; ///< by node and class
    std::vector<std::int64_t> m_MeshIds;
    std::map<std::string, int> m_Counts; ///< of the objects so far, by what they have in common
    std::string m_Text;
};

} // namespace

std::string PrefabTextOf(const Model& model, const std::string& guid)
{
    return PrefabWriter(model, guid).Write();
}

} // namespace limn

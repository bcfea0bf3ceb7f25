#pragma once

#include "unity/UnityTree.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <limn/volume/UnityAsset.h>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <vector>

namespace limn
{

/// The class ids of Unity that limn reads. In `--- !u!4 &123` the class id is 4.
enum class UnityClass : int
{
    GameObject = 1,
    Transform = 4,
    Camera = 20,
    Material = 21,
    MeshRenderer = 23,
    Texture2D = 28,
    MeshFilter = 33,
    Mesh = 43,
    BoxCollider = 65,
    MeshCollider = 64,
    RenderTexture = 84,
    RenderSettings = 104,
    Light = 108,
    MonoBehaviour = 114,
    Texture3D = 117,
    SphereCollider = 135,
    CapsuleCollider = 136,
    SkinnedMeshRenderer = 137,
    Texture2DArray = 187,
    LODGroup = 205,
    SpriteRenderer = 212,
    RectTransform = 224,
    PrefabInstance = 1001
};

/// Returns Unity's name of a class, "MeshRenderer", or "component 198" if limn knows none.
std::string NameOf(UnityClass classID);

/// A reference `{fileID: 11400000, guid: 185ced…, type: 2}`. If the guid is empty, it refers to an
/// object of the file itself; if the fileID is 0, to nothing.
struct UnityReference
{
    std::int64_t fileID = 0;
    std::string guid;

    bool isNull() const { return fileID == 0; }
    auto operator<=>(const UnityReference&) const = default;
};

UnityReference ReadUnityReference(const UnityNode& node);

/// A text asset of Unity. Its objects are parsed when they are asked for, each once.
class UnityFile
{
public:
    /// @throws AssetError as UnityAsset
    UnityFile(std::string text, std::string name);
    UnityFile(const UnityFile&) = delete;
    UnityFile& operator=(const UnityFile&) = delete;

    const std::string& name() const { return m_Asset.file(); }
    std::span<const UnityHeader> headers() const { return m_Asset.headers(); }
    /// Returns the map below the class's name.
    /// @throws AssetError as UnityTree
    UnityNode Fields(const UnityHeader& header) const;

private:
    UnityAsset m_Asset;
    mutable std::unordered_map<std::int64_t, std::unique_ptr<const UnityTree>> m_Trees;
};

struct UnityScope;

/// A value that a prefab instance gives to a property of an object.
struct UnityOverride
{
    std::string path; ///< "m_Materials.Array.data[0]"
    std::string value;
    UnityReference reference;
    const UnityScope* scope = nullptr; ///< the scope that a reference without a guid is in
    int line = 0;                      ///< in the scope's file
};

/// An object of a scene once all prefabs are expanded.
struct UnityInstance
{
    UnityClass classID{};
    std::int64_t fileID = 0; ///< the id within its scope
    int line = 0;
    const UnityScope* scope = nullptr; ///< the scope that it is in
    UnityNode fields;
    std::vector<UnityOverride> overrides; ///< later ones win
    bool isRemoved = false;

    /// Returns whether it is a Transform, including one of the user interface.
    bool isTransform() const
    {
        return classID == UnityClass::Transform || classID == UnityClass::RectTransform;
    }
};

/// One use of a file: its objects by the ids in its text, including the objects of prefabs in it.
struct UnityScope
{
    std::shared_ptr<const UnityFile> file;
    std::unordered_map<std::int64_t, UnityInstance*> objects;

    /// Returns the object with this id, or null if there is none.
    UnityInstance* Find(std::int64_t fileID) const;
};

/// A scene or prefab with everything that its prefab instances stand for.
/// Unity: PrefabInstance, by the rules of 2018.3 and later.
class UnityExpansion
{
public:
    /// Returns the text asset behind a guid, or null if the project has none. A model is returned
    /// as the prefab that Unity makes of it.
    using FindPrefab = std::function<std::shared_ptr<const UnityFile>(const std::string& guid)>;

    /// @throws AssetError  if a file is broken, if a prefab contains itself, or if there are more
    ///     objects than limn takes
    UnityExpansion(std::shared_ptr<const UnityFile> file, FindPrefab find);
    UnityExpansion(const UnityExpansion&) = delete;
    UnityExpansion& operator=(const UnityExpansion&) = delete;

    const UnityScope& root() const { return *m_Root; }
    /// Returns all objects that were not removed, in the order of the files.
    const std::vector<const UnityInstance*>& objects() const { return m_Objects; }
    /// Returns notes about what was left out, one for each cause.
    const std::vector<Diagnostic>& notes() const { return m_Notes; }

private:
    UnityScope& Expand(const std::shared_ptr<const UnityFile>& file);
    void AddInstance(UnityScope& scope, const UnityHeader& header,
                     const std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t>& stripped);

    FindPrefab m_Find;
    std::deque<UnityScope> m_Scopes;
    std::deque<UnityInstance> m_Instances;
    std::vector<const UnityFile*> m_Stack; ///< files that are being expanded
    std::vector<const UnityInstance*> m_Objects;
    std::set<std::string> m_Missing; ///< guids that already have a note
    std::vector<Diagnostic> m_Notes;
    UnityScope* m_Root = nullptr;
};

} // namespace limn

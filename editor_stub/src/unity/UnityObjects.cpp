#include "unity/UnityObjects.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::size_t k_MostObjects = 1'000'000;
constexpr std::size_t k_DeepestPrefab = 64;
constexpr std::int64_t k_WithoutSign = 0x7FFF'FFFF'FFFF'FFFF;

constexpr std::pair<UnityClass, const char*> k_ClassNames[] = {
    {UnityClass::GameObject, "GameObject"},
    {UnityClass::Transform, "Transform"},
    {UnityClass::Camera, "Camera"},
    {UnityClass::MeshRenderer, "MeshRenderer"},
    {UnityClass::MeshFilter, "MeshFilter"},
    {UnityClass::Light, "Light"},
    {UnityClass::MonoBehaviour, "MonoBehaviour"},
    {UnityClass::SkinnedMeshRenderer, "SkinnedMeshRenderer"},
    {UnityClass::SpriteRenderer, "SpriteRenderer"},
    {UnityClass::LODGroup, "LODGroup"},
    {UnityClass::BoxCollider, "BoxCollider"},
    {UnityClass::SphereCollider, "SphereCollider"},
    {UnityClass::CapsuleCollider, "CapsuleCollider"},
    {UnityClass::MeshCollider, "MeshCollider"},
    {UnityClass::RenderSettings, "RenderSettings"}};

/// Returns the value of a key, or that of the key that Unity had for it before 2018.3.
UnityNode FindEither(const UnityNode& fields, std::string_view key, std::string_view older)
{
    const UnityNode found = fields[key];
    return found ? found : fields[older];
}

/// The id in a prefab file of an object that no stripped document names.
std::int64_t IdOfInstanced(std::int64_t instance, std::int64_t source)
{
    return (instance ^ source) & k_WithoutSign;
}

/// Instances of the ids that this file has for single objects of their sources.
std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> StrippedIds(const UnityFile& file)
{
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> ids;
    for (const UnityHeader& header : file.headers())
    {
        if (header.isStripped)
        {
            const UnityNode fields = file.Fields(header);
            const UnityNode instance = FindEither(fields, "m_PrefabInstance", "m_PrefabInternal");
            const UnityNode source =
                FindEither(fields, "m_CorrespondingSourceObject", "m_PrefabParentObject");
            ids[{ReadUnityReference(instance).fileID, ReadUnityReference(source).fileID}] =
                header.fileID;
        }
    }
    return ids;
}

} // namespace

std::string NameOf(UnityClass classID)
{
    const auto found =
        std::ranges::find(k_ClassNames, classID, &std::pair<UnityClass, const char*>::first);
    return found != std::end(k_ClassNames)
               ? found->second
               : "component " + std::to_string(static_cast<int>(classID));
}

UnityReference ReadUnityReference(const UnityNode& node)
{
    return {NumberOf(node["fileID"], std::int64_t{0}), std::string(node["guid"].text())};
}

UnityFile::UnityFile(std::string text, std::string name) : m_Asset(std::move(text), std::move(name))
{
}

UnityNode UnityFile::Fields(const UnityHeader& header) const
{
    std::unique_ptr<const UnityTree>& tree = m_Trees[header.fileID];
    if (!tree)
    {
        tree = std::make_unique<const UnityTree>(m_Asset.BodyOf(header), name(), header.line + 1);
    }
    const UnityNode root = tree->root();
    return root.begin() == root.end() ? UnityNode() : *root.begin();
}

UnityInstance* UnityScope::Find(std::int64_t fileID) const
{
    const auto found = objects.find(fileID);
    return found == objects.end() ? nullptr : found->second;
}

UnityExpansion::UnityExpansion(std::shared_ptr<const UnityFile> file, FindPrefab find)
    : m_Find(std::move(find))
{
    m_Root = &Expand(file);
    for (const UnityInstance& instance : m_Instances)
    {
        if (!instance.isRemoved)
        {
            m_Objects.push_back(&instance);
        }
    }
}

UnityScope& UnityExpansion::Expand(const std::shared_ptr<const UnityFile>& file)
{
    if (std::ranges::find(m_Stack, file.get()) != m_Stack.end())
    {
        throw AssetError(file->name(), {}, "this prefab holds itself, be it in another one");
    }
    if (m_Stack.size() == k_DeepestPrefab)
    {
        throw AssetError(file->name(), {},
                         "prefabs are nested deeper than " + std::to_string(k_DeepestPrefab) +
                             " levels");
    }
    m_Stack.push_back(file.get());
    UnityScope& scope = m_Scopes.emplace_back();
    scope.file = file;
    for (const UnityHeader& header : file->headers())
    {
        const auto classID = static_cast<UnityClass>(header.classID);
        if (!header.isStripped && classID != UnityClass::PrefabInstance)
        {
            UnityInstance& object = m_Instances.emplace_back();
            object.classID = classID;
            object.fileID = header.fileID;
            object.line = header.line;
            object.scope = &scope;
            object.fields = file->Fields(header);
            scope.objects[header.fileID] = &object;
        }
    }
    const auto stripped = StrippedIds(*file);
    for (const UnityHeader& header : file->headers())
    {
        if (static_cast<UnityClass>(header.classID) == UnityClass::PrefabInstance &&
            !header.isStripped)
        {
            AddInstance(scope, header, stripped);
        }
    }
    if (m_Instances.size() > k_MostObjects)
    {
        throw AssetError(file->name(), {},
                         "with its prefabs it has more than " + std::to_string(k_MostObjects) +
                             " objects, which limn does not take");
    }
    m_Stack.pop_back();
    return scope;
}

void UnityExpansion::AddInstance(
    UnityScope& scope, const UnityHeader& header,
    const std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t>& stripped)
{
    const UnityNode fields = scope.file->Fields(header);
    const UnityReference prefab =
        ReadUnityReference(FindEither(fields, "m_SourcePrefab", "m_ParentPrefab"));
    if (prefab.isNull() || fields["m_IsPrefabAsset"].text() == "1")
    {
        return; // the file's own, as Unity wrote it before 2018.3
    }
    const std::shared_ptr<const UnityFile> source = m_Find(prefab.guid);
    if (!source)
    {
        if (m_Missing.insert(prefab.guid).second)
        {
            m_Notes.push_back({Severity::Note,
                               scope.file->name(),
                               {header.line, 1},
                               "a prefab is left out: the file with its guid " + prefab.guid +
                                   " is not in the project, or it cannot be read"});
        }
        return;
    }
    UnityScope& inner = Expand(source);
    for (const auto& [id, object] : inner.objects)
    {
        const auto named = stripped.find({header.fileID, id});
        scope.objects[named != stripped.end() ? named->second : IdOfInstanced(header.fileID, id)] =
            object;
    }
    const UnityNode modification = fields["m_Modification"];
    for (const UnityNode entry : modification["m_Modifications"])
    {
        // Unity, too, keeps what it says of objects that are gone.
        if (UnityInstance* target = inner.Find(ReadUnityReference(entry["target"]).fileID))
        {
            target->overrides.push_back(
                {std::string(entry["propertyPath"].text()), std::string(entry["value"].text()),
                 ReadUnityReference(entry["objectReference"]), &scope, entry.line()});
        }
    }
    for (const char* list : {"m_RemovedComponents", "m_RemovedGameObjects"})
    {
        for (const UnityNode entry : modification[list])
        {
            if (UnityInstance* target = inner.Find(ReadUnityReference(entry).fileID))
            {
                target->isRemoved = true;
            }
        }
    }
    // The source's root hangs where the instance says.
    for (const auto& [id, object] : inner.objects)
    {
        if (object->isTransform() && ReadUnityReference(object->fields["m_Father"]).isNull() &&
            std::ranges::find(object->overrides, "m_Father", &UnityOverride::path) ==
                object->overrides.end())
        {
            object->overrides.push_back({"m_Father",
                                         {},
                                         ReadUnityReference(modification["m_TransformParent"]),
                                         &scope,
                                         header.line});
        }
    }
}

} // namespace limn

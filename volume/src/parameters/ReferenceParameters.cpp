#include <limn/volume/AssetParameters.h>

namespace limn
{

namespace
{

/// "a.png:3:4: what is wrong", for an error of a file that another one refers to.
std::string InOneLine(const Diagnostic& error)
{
    const SourceLocation& place = error.location;
    const std::string numbers =
        place.line == 0 ? ""
                        : ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
    return error.file + numbers + ": " + error.message;
}

/// Puts what `load` gives into `value`; false, with its errors at the node and the value as it was
/// before, if it throws some.
template <typename Asset, typename Load>
bool LoadReference(const YamlNode& node, const std::string& subject, AssetDiagnostics& diagnostics,
                   AssetReference<Asset>& value, const AssetReference<Asset>& before,
                   const Load& load)
{
    try
    {
        LoadedAsset<Asset> loaded = load(value.location);
        value.asset = std::move(loaded.asset);
        if (!loaded.note.empty())
        {
            diagnostics.Note(node.location(), subject + ": " + loaded.note);
        }
        return true;
    }
    catch (const AssetError& failure)
    {
        for (const Diagnostic& error : failure.diagnostics())
        {
            diagnostics.Error(node.location(), subject + ": " + InOneLine(error));
        }
        value = before;
        return false;
    }
}

} // namespace

bool TextureParameter::ReadNode(const YamlNode& node, std::string_view subject,
                                AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    const TextureReference before = m_Value;
    const bool isRead = ValueParameter::ReadNode(node, subject, diagnostics, context);
    if (!isRead || m_Value.location.isNull() || !context.loadsAssets())
    {
        return isRead;
    }
    if (!isLoadable())
    {
        diagnostics.Note(node.location(), std::string(subject) +
                                              ": it stays without a texture: a " +
                                              std::string(typeName()) +
                                              " cannot be loaded from a file; only flat textures "
                                              "can");
        return true;
    }
    return LoadReference(node, std::string(subject), diagnostics, m_Value, before,
                         [&context](const AssetLocation& location)
                         { return context.LoadTexture(location); });
}

bool MaterialParameter::ReadNode(const YamlNode& node, std::string_view subject,
                                 AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    const MaterialReference before = m_Value;
    const bool isRead = ValueParameter::ReadNode(node, subject, diagnostics, context);
    if (!isRead || m_Value.location.isNull() || !context.loadsAssets())
    {
        return isRead;
    }
    return LoadReference(node, std::string(subject), diagnostics, m_Value, before,
                         [&context](const AssetLocation& location)
                         { return context.LoadMaterial(location); });
}

} // namespace limn

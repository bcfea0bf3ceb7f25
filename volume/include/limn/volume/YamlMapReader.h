#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limn/volume/YamlRead.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// Reads a map key by key and reports the keys that were not read. A key asked for by Unity's
/// serialised name ("m_OutlineWidth") is also found under its plain spelling ("outlineWidth").
///
///     YamlMapReader map{node, "camera", diagnostics};
///     map.Read("fieldOfView", camera.fieldOfView, {1, 179});
///     if (const YamlNode* objects = map.Find("objects")) { ... }
///     map.Finish();
///
/// Every problem is an error in `diagnostics`; a Null counts as an empty map. `diagnostics` must
/// outlive the reader.
class YamlMapReader
{
public:
    /// @param subject  the name of the map's subject in messages: "camera"
    /// @param noun     the word for its keys in messages about unknown ones: "parameter"
    YamlMapReader(YamlNode node, std::string subject, AssetDiagnostics& diagnostics,
                  std::string noun = "key");

    /// Returns the value of `key`, or null if the file does not have it. Makes the key known to
    /// Finish. The value lives as long as the reader.
    const YamlNode* Find(std::string_view key);

    /// Returns the value of `key` like Find; a missing key is an error.
    const YamlNode* Require(std::string_view key);

    /// Sets `value` if the map has the key with a valid value, and returns whether it did.
    template <typename T>
    bool Read(std::string_view key, T& value, ValueRange range = {})
    {
        const YamlNode* node = Find(key);
        return node && ReadValue(*node, SubjectOf(key), m_Diagnostics, value, range);
    }
    bool Read(std::string_view key, Color& value) { return Read(key, value, k_ColorChannels); }

    /// Reports every key that was not asked for, with the nearest key that was.
    /// @param elsewhere  paths of keys in other maps, such as "settings.width"; the report names
    ///     one whose last part is the unknown key
    void Finish(std::span<const std::string> elsewhere = {});

    /// Returns "camera.fieldOfView", the subject for readers of a value of this map.
    std::string SubjectOf(std::string_view key) const;
    const YamlNode& node() const { return m_Node; }
    const std::string& noun() const { return m_Noun; }

private:
    void ReportTwice(const YamlEntry& first, const YamlEntry& second);

    YamlNode m_Node;
    std::string m_Subject;
    std::string m_Noun;
    AssetDiagnostics& m_Diagnostics;
    std::vector<std::string> m_Known; ///< as asked for
};

/// Returns a serialised name as a person may write it: "outlineWidth" for "m_OutlineWidth". A name
/// without m_ stays as it is.
std::string PlainSpelling(std::string_view serializedName);

} // namespace limn

#pragma once

#include "unity/UnityObjects.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>

namespace limn
{

/// Collects notes about a project's files while its scene is read. None of them keeps the scene
/// from being drawn.
class UnityNotes
{
public:
    /// Adds a sentence, once.
    void Add(const std::string& file, int line, const std::string& message);
    void Add(std::span<const Diagnostic> notes);
    /// Counts a thing of a kind that limn does not draw. Finish() makes one sentence for each kind.
    void Count(const std::string& kind) { ++m_Counts[kind]; }
    /// Returns the notes, with a sentence for each kind of counted things.
    /// @param file  the file that the counted things are in
    std::vector<Diagnostic> Finish(const std::string& file);

private:
    std::vector<Diagnostic> m_Notes;
    std::set<std::pair<std::string, std::string>> m_Known; ///< pairs of file and message
    std::map<std::string, int> m_Counts;
};

/// The target of an object's reference: another object of the expansion, an asset by its guid,
/// or nothing.
struct UnityTarget
{
    const UnityInstance* object = nullptr;
    UnityReference asset; ///< null if it is no asset

    bool isNull() const { return object == nullptr && asset.isNull(); }
};

/// Reads the fields of one object, with the values that prefab instances give them. Numbers are
/// read by the type of `value`. A missing field leaves the value as it was. A wrong field does so,
/// too, and becomes a note.
///
/// Paths are Unity's property paths: "m_LocalPosition.x", "m_Materials.Array.data[0]".
class UnityReader
{
public:
    /// @param subject  the object's name in notes: "Sphere/MeshRenderer"
    UnityReader(const UnityInstance& object, std::string subject, UnityNotes& notes)
        : m_Object(object), m_Subject(std::move(subject)), m_Notes(notes)
    {
    }

    void Read(const std::string& path, float& value) const;
    void Read(const std::string& path, int& value) const;
    void Read(const std::string& path, bool& value) const;
    void Read(const std::string& path, std::string& value) const;
    void Read(const std::string& path, glm::vec3& value) const;
    void Read(const std::string& path, glm::quat& value) const;
    void Read(const std::string& path, Color& value) const;     ///< sRGB
    void Read(const std::string& path, LayerMask& value) const; ///< as {m_Bits: 5}
    /// Reads bits that are saved as one number.
    void Read(const std::string& path, RenderingLayerMask& value) const;
    /// Reads a number that has to lie in a range.
    void ReadIn(const std::string& path, float least, float most, float& value) const;
    /// Reads a member of an enum, from 0 to `last`.
    template <typename Enum>
    void ReadEnum(const std::string& path, Enum last, Enum& value) const
    {
        float number = static_cast<float>(value);
        ReadIn(path, 0.0f, static_cast<float>(last), number);
        value = static_cast<Enum>(static_cast<int>(number));
    }

    UnityTarget Reference(const std::string& path) const;
    /// Returns the number of elements of a list, as the prefab instances have made it.
    std::size_t Count(const std::string& path) const;
    bool Has(const std::string& path) const { return Find(path) || FindOverride(path) != nullptr; }
    UnityNode Find(const std::string& path) const; ///< finds a value in the object's own text

    void Note(const std::string& path, const std::string& message) const;

private:
    const UnityOverride* FindOverride(std::string_view path) const;
    /// Returns the text of a scalar, or nothing if there is none.
    std::optional<std::string_view> Text(const std::string& path) const;
    void ReadParts(const std::string& path, const char* names, float* values) const;

    const UnityInstance& m_Object;
    std::string m_Subject;
    UnityNotes& m_Notes;
};

} // namespace limn

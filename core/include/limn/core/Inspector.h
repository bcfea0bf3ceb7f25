#pragma once

#include <glm/vec4.hpp>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/RenderPassEvent.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

class Material;
class Shader;

/// One member of an enum setting.
struct EnumEntry
{
    std::string_view name;
    int value = 0;
};

/// The allowed numbers of a setting, both ends included.
struct FieldRange
{
    double minimum = 0.0;
    double maximum = 0.0;
};

/// What a feature's settings are told to, one by one, in the order a person should see them: a
/// loader writes them, a printer reads them. The counterpart of Unity's [Header], [Range],
/// [Tooltip] and [SerializeField]. A field's default is the value it has before anything is loaded.
class Inspector
{
public:
    virtual ~Inspector() = default;

    /// A title over the fields that follow. Unity: [Header].
    virtual void Header(std::string_view text) = 0;

    /// @param name     the serialised name, Unity's ("m_LayerMask")
    /// @param tooltip  one sentence for the user
    virtual void Field(std::string_view name, bool& value, std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, int& value, FieldRange range,
                       std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, float& value, FieldRange range,
                       std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, Color& value, std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, LayerMask& value, std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, RenderPassEvent& value, std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, std::shared_ptr<const Shader>& value,
                       std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, std::shared_ptr<const Material>& value,
                       std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, glm::vec4& value, std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, std::string& value, std::string_view tooltip) = 0;
    virtual void Field(std::string_view name, std::vector<std::string>& value,
                       std::string_view tooltip) = 0;
    /// The index 0...31 of a rendering layer; may be given by the layer's name.
    virtual void RenderingLayerIndex(std::string_view name, int& value,
                                     std::string_view tooltip) = 0;
    virtual void EnumField(std::string_view name, int& value, std::span<const EnumEntry> entries,
                           std::string_view tooltip) = 0;

    /// Fields until EndGroup are members of one setting: `stencilSettings: {stencilReference: 1}`.
    /// Groups are not nested. Unity: a field whose type is a [Serializable] class.
    virtual void BeginGroup(std::string_view name) = 0;
    virtual void EndGroup() = 0;

    template <typename Enum>
    void Field(std::string_view name, Enum& value, std::span<const EnumEntry> entries,
               std::string_view tooltip)
    {
        int number = static_cast<int>(value);
        EnumField(name, number, entries, tooltip);
        value = static_cast<Enum>(number);
    }
};

/// All members of RenderPassEvent, CompareFunction and StencilOp, for settings of these types.
std::span<const EnumEntry> RenderPassEventEntries();
std::span<const EnumEntry> CompareFunctionEntries();
std::span<const EnumEntry> StencilOpEntries();

} // namespace limn

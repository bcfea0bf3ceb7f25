#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <limn/core/Color.h>
#include <limn/core/LayerMask.h>
#include <limn/core/RenderPassEvent.h>
#include <limn/core/ValueRange.h>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
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

/// One sentence for the user, of settings where a name would look like a default.
struct TooltipText
{
    /// A shader's name, "Hidden/Blur", which no word in lower case tells from one, does not
    /// compile.
    template <std::size_t Size>
    consteval TooltipText(const char (&words)[Size]) : text(words)
    {
        bool isName = text.find('/') != text.npos;
        for (std::size_t i = 0; i < text.size(); ++i)
        {
            const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '/';
            isName = isName && !(begins && text[i] >= 'a' && text[i] <= 'z');
        }
        if (isName)
        {
            throw "this is the tooltip, a sentence; a default is what the member begins with";
        }
    }
    template <std::convertible_to<std::string_view> Words>
    requires(!std::is_array_v<Words>) constexpr TooltipText(const Words& words) : text(words) {}

    std::string_view text;
};

/// What a person is told about a setting.
struct FieldInfo
{
    std::string_view name;                          ///< the serialised one, Unity's ("m_LayerMask")
    std::string_view tooltip;                       ///< one sentence for the user
    std::optional<ValueRange> range = std::nullopt; ///< of a number; none: any number
};

/// A setting of an enum type, as a number.
struct EnumValue
{
    int& value;
    std::span<const EnumEntry> entries;
};

/// The index 0...31 of a rendering layer; may be given by the layer's name.
struct RenderingLayerValue
{
    int& value;
};

/// A setting, to be read or written where it is.
using FieldValue = std::variant<bool*, int*, std::uint32_t*, float*, Color*, glm::vec4*, LayerMask*,
                                RenderingLayerMask*, RenderPassEvent*, std::string*,
                                std::vector<std::string>*, std::shared_ptr<const Shader>*,
                                std::shared_ptr<const Material>*, EnumValue, RenderingLayerValue>;

/// What a feature's settings are told to, one by one, in the order a person should see them: a
/// loader writes them, a printer reads them. The counterpart of Unity's [Header], [Range],
/// [Tooltip] and [SerializeField]. A field's default is the value it has before anything is loaded.
class Inspector
{
public:
    virtual ~Inspector() = default;

    /// A title over the fields that follow. Unity: [Header].
    virtual void Header(std::string_view) {}

    /// What every other Field comes down to.
    virtual void Field(const FieldInfo& field, FieldValue value) = 0;

    /// Fields until EndGroup are members of one setting: `stencilSettings: {stencilReference: 1}`,
    /// "stencilSettings.stencilReference" on a command line. Groups may hold groups. Unity: a field
    /// whose type is a [Serializable] class. A class that Describe does not group may still stand
    /// in files: its members are then read as if they stood beside it.
    virtual void BeginGroup(std::string_view) {}
    virtual void EndGroup() {}

    template <typename T>
    void Field(std::string_view name, T& value, std::string_view tooltip)
    {
        static_assert(std::is_constructible_v<FieldValue, T*>,
                      "a setting is a bool, int, float, Color, vec4, LayerMask, RenderPassEvent, "
                      "string or list of strings, a shared_ptr of const Shader or of Material, or "
                      "an enum with its entries behind it");
        if constexpr (std::is_constructible_v<FieldValue, T*>)
        {
            Field({name, tooltip}, &value);
        }
    }
    /// A default is what the member begins with: `Shader.Find` in Create, or the file.
    void Field(std::string_view name, std::shared_ptr<const Shader>& value, TooltipText tooltip)
    {
        Field({name, tooltip.text}, &value);
    }
    /// A material whose properties the feature may set, for all that use it, as in Unity.
    void Field(std::string_view name, std::shared_ptr<Material>& value, TooltipText tooltip)
    {
        std::shared_ptr<const Material> material = value;
        Field({name, tooltip.text}, &material);
        value = std::const_pointer_cast<Material>(material);
    }
    void Field(std::string_view name, std::shared_ptr<const Material>& value, TooltipText tooltip)
    {
        Field({name, tooltip.text}, &value);
    }
    void Field(std::string_view name, int& value, ValueRange range, std::string_view tooltip)
    {
        Field({name, tooltip, range}, &value);
    }
    void Field(std::string_view name, std::uint32_t& value, ValueRange range,
               std::string_view tooltip)
    {
        Field({name, tooltip, range}, &value);
    }
    void Field(std::string_view name, float& value, ValueRange range, std::string_view tooltip)
    {
        Field({name, tooltip, range}, &value);
    }
    template <typename Enum>
    void Field(std::string_view name, Enum& value, std::span<const EnumEntry> entries,
               std::string_view tooltip)
    {
        int number = static_cast<int>(value);
        Field({name, tooltip}, EnumValue{number, entries});
        value = static_cast<Enum>(number);
    }
    void RenderingLayerIndex(std::string_view name, int& value, std::string_view tooltip)
    {
        Field({name, tooltip}, RenderingLayerValue{value});
    }
};

/// All members of RenderPassEvent, CompareFunction and StencilOp, for settings of these types.
std::span<const EnumEntry> RenderPassEventEntries();
std::span<const EnumEntry> CompareFunctionEntries();
std::span<const EnumEntry> StencilOpEntries();

} // namespace limn

#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
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

class ComputeShader;
class Material;
class Shader;
class Texture;

/// One member of an enum setting. If one is named Everything, the members are bits of a set.
struct EnumEntry
{
    std::string_view name;
    int value = 0;
};

/// A tooltip: one sentence for the user, for settings where a name would look like a default.
struct TooltipText
{
    /// Does not compile for a shader's name such as "Hidden/Blur". A text counts as one if it has a
    /// slash and none of its words begins in lower case.
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

/// The description of a setting for the user.
struct FieldInfo
{
    std::string_view name;    ///< the serialised name, Unity's ("m_LayerMask")
    std::string_view tooltip; ///< one sentence for the user
    std::optional<ValueRange> range = std::nullopt; ///< of a number; none: any number
};

/// A setting of an enum type, as a number.
struct EnumValue
{
    int& value;
    std::span<const EnumEntry> entries;
};

/// The index 0...31 of a rendering layer; it may be given by the layer's name.
struct RenderingLayerValue
{
    int& value;
};

/// A pointer to a setting, to read or write it in place.
using FieldValue =
    std::variant<bool*, int*, std::uint32_t*, float*, Color*, glm::vec2*, glm::vec3*, glm::vec4*,
                 LayerMask*, RenderingLayerMask*, RenderPassEvent*, std::string*,
                 std::vector<std::string>*, std::shared_ptr<const Shader>*,
                 std::shared_ptr<const Material>*, std::shared_ptr<const Texture>*,
                 std::shared_ptr<const ComputeShader>*, EnumValue, RenderingLayerValue>;

/// Receives a feature's settings one by one, in the order in which a person should see them: a
/// loader writes them, a printer reads them. It is the counterpart of Unity's [Header], [Range],
/// [Tooltip] and [SerializeField]. The default of a field is the value that it has before anything
/// is loaded.
class Inspector
{
public:
    virtual ~Inspector() = default;

    /// Begins a section with a title over the fields that follow. Unity: [Header].
    virtual void Header(std::string_view) {}

    /// Receives one setting; every other overload calls this one.
    virtual void Field(const FieldInfo& field, FieldValue value) = 0;

    /// Begins a group: the fields until EndGroup are members of one setting: `stencilSettings:
    /// {stencilReference: 1}`, "stencilSettings.stencilReference" on a command line. Groups may
    /// hold groups. Unity: a field whose type is a [Serializable] class. Files may also have a
    /// class that Describe does not group: its members are then read as if they stood beside it.
    virtual void BeginGroup(std::string_view) {}
    virtual void EndGroup() {}

    template <typename T>
    void Field(std::string_view name, T& value, std::string_view tooltip)
    {
        constexpr bool k_IsPointer = requires
        {
            typename T::element_type;
        };
        static_assert(std::is_constructible_v<FieldValue, T*> || k_IsPointer,
                      "a setting is a bool, int, float, Color, vec2, vec3, vec4, LayerMask, "
                      "RenderPassEvent, string or list of strings, a shared_ptr of const Shader, "
                      "of Material, of const Texture or of ComputeShader, or an enum with its "
                      "entries behind it");
        if constexpr (std::is_constructible_v<FieldValue, T*>)
        {
            Field({name, tooltip}, &value);
        }
        else if constexpr (k_IsPointer) // Shared<Material>
        {
            using Asset = typename T::element_type;
            using Named = std::shared_ptr<const std::remove_const_t<Asset>>;
            constexpr bool k_IsTexture = !std::is_constructible_v<FieldValue, Named*>;
            std::conditional_t<k_IsTexture, std::shared_ptr<const Texture>, Named> asset = value;
            Field({name, tooltip}, &asset);
            if constexpr (k_IsTexture) // of one dimension; a file may name another
            {
                value = std::const_pointer_cast<Asset>(
                    std::dynamic_pointer_cast<const std::remove_const_t<Asset>>(asset));
            }
            else
            {
                value = std::const_pointer_cast<Asset>(asset);
            }
        }
    }
    /// Receives a shader. Its default is the value of the member at the beginning; `Shader.Find` in
    /// Create or the file sets it otherwise.
    void Field(std::string_view name, std::shared_ptr<const Shader>& value, TooltipText tooltip)
    {
        Field({name, tooltip.text}, &value);
    }
    /// Receives a material whose properties the feature may set, for all that use it, as in Unity.
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
    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void Field(std::string_view name, Number& value, ValueRange range, std::string_view tooltip)
    {
        Field({name, tooltip, range}, &value);
    }
    template <typename Enum>
    requires std::is_enum_v<Enum>
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

/// Return the members of an enum of Unity's, for settings of its type. A CameraType is a set.
std::span<const EnumEntry> RenderPassEventEntries();
std::span<const EnumEntry> CompareFunctionEntries();
std::span<const EnumEntry> StencilOpEntries();
std::span<const EnumEntry> CameraTypeEntries();
std::span<const EnumEntry> FilterModeEntries();
std::span<const EnumEntry> TextureWrapModeEntries();
std::span<const EnumEntry> RenderTextureFormatEntries();
std::span<const EnumEntry> CullModeEntries();
std::span<const EnumEntry> BlendModeEntries();

} // namespace limn

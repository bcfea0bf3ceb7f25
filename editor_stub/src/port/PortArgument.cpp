#include "port/PortMember.h"

#include <algorithm>
#include <map>

namespace limn
{

namespace
{

/// Returns whether the argument has its name before it: pass: 1.
bool IsNamed(const CSharpWords& words)
{
    return words.size() > 2 && words[0].isName() && words[1].Is(":");
}

} // namespace

std::optional<PortMembers::Argument> PortMembers::OneArgument(CSharpWords words) const
{
    const bool isReference = !words.empty() && IsIn(words[0].text, {"ref", "in", "out"});
    words = words.subspan(isReference ? 1 : 0);
    const bool isDeclared =
        isReference && words.size() == 2 && words[0].isName() && words[1].isName(); // out uint x
    words = words.subspan(isDeclared ? 1 : 0);
    const auto value = Translate(m_Place, words, "", &m_Problem);
    if (!value || value->isType || value->type == "void")
    {
        return std::nullopt;
    }
    const bool isList = value->cpp.starts_with("{") && !ElementTypeOf(value->type).empty();
    const auto list = isList ? model().CppType(value->type) : std::nullopt;
    return Argument{*value,
                    value->type == "null" ? "nullptr" : list.value_or("") + value->Object()};
}

/// Returns the arguments in the order of the names that the table has for the method.
std::optional<std::vector<PortMembers::Argument>>
PortMembers::OrderedArguments(const std::vector<PortParameter>& names,
                              const std::vector<CSharpWords>& words) const
{
    std::vector<std::optional<Argument>> places(names.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const bool isNamed = IsNamed(words[i]);
        const std::string_view name = isNamed ? words[i][0].text : std::string_view();
        const auto place =
            isNamed ? static_cast<std::size_t>(
                          std::ranges::find(names, name, &PortParameter::name) - names.begin())
                    : i;
        if (place >= places.size())
        {
            Fail("the named argument '" + std::string(name) + "'");
            return std::nullopt;
        }
        places[place] = OneArgument(isNamed ? words[i].subspan(2) : words[i]);
        if (!places[place])
        {
            return std::nullopt;
        }
        count = std::max(count, place + 1);
    }
    std::vector<Argument> arguments;
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::string& otherwise = names[i].otherwise;
        if (!places[i] && otherwise.empty())
        {
            Fail("no argument '" + names[i].name + "'");
            return std::nullopt;
        }
        arguments.push_back(places[i] ? *places[i] : Argument{{otherwise, ""}, otherwise});
    }
    return arguments;
}

/// @param key  the table's, of a method or a constructor
std::optional<std::vector<PortMembers::Argument>>
PortMembers::Arguments(const std::string& key, const std::vector<CSharpWords>& words) const
{
    const auto names = model().table().ParametersOf(key);
    if (!names.empty() && std::ranges::any_of(words, IsNamed))
    {
        return OrderedArguments(names, words);
    }
    std::vector<Argument> arguments;
    for (CSharpWords one : words)
    {
        const bool isNamed = IsNamed(one);
        // These stand where the C++ has them, too, if they are the last ones.
        const bool isLast = arguments.size() + 1 == words.size();
        const bool isPassName = isNamed && one[0].Is("passName");
        if (isNamed && isLast &&
            (IsIn(one[0].text, {"pass", "passIndex", "flags", "index"}) || isPassName))
        {
            if (isPassName && words.size() == 5) // behind a scale and an offset
            {
                const std::string filter = "RenderGraphUtils::BlitFilterMode::ClampBilinear";
                arguments.push_back({{filter, ""}, filter});
            }
            one = one.subspan(2);
        }
        else if (isNamed)
        {
            Fail("the named argument '" + std::string(one[0].text) + "'");
            return std::nullopt;
        }
        const auto argument = OneArgument(one);
        if (!argument)
        {
            return std::nullopt;
        }
        arguments.push_back(*argument);
    }
    return arguments;
}

/// Returns the arguments of ReAllocateIfNeeded: those behind the first two become members of
/// ReAllocateArguments.
std::optional<std::vector<PortMembers::Argument>>
PortMembers::NamedArguments(const std::vector<CSharpWords>& words) const
{
    static const std::vector<std::string> names{"filterMode", "wrapMode",   "isShadowMap",
                                                "anisoLevel", "mipMapBias", "name"};
    std::vector<Argument> arguments;
    std::size_t first = 2; // behind the handle and the descriptor
    std::map<std::size_t, std::string> members;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const bool isNamed = IsNamed(words[i]);
        const auto argument = OneArgument(isNamed ? words[i].subspan(2) : words[i]);
        if (!argument)
        {
            return std::nullopt;
        }
        const auto name = isNamed ? std::ranges::find(names, words[i][0].text) : names.end();
        const auto place = isNamed ? static_cast<std::size_t>(name - names.begin()) : i - first;
        first = i == 1 && argument->value.type == "Vector2" ? 3 : first; // a scale before it
        if (!isNamed && i < first)
        {
            arguments.push_back(*argument);
        }
        else if (place < names.size())
        {
            members[place] = "." + names[place] + " = " + argument->text;
        }
        else
        {
            Fail("the named argument '" + std::string(words[i][0].text) + "'");
            return std::nullopt;
        }
    }
    std::string list;
    for (const auto& [place, text] : members)
    {
        list += (list.empty() ? "{" : ", ") + text;
    }
    arguments.push_back({{list + "}", ""}, list + "}"});
    return arguments;
}

std::optional<std::vector<PortMembers::Argument>>
PortMembers::ArgumentsOf(const std::string& owner, const PortName& name) const
{
    const bool hasNamed = std::ranges::any_of(name.arguments, IsNamed);
    const bool isAgain = owner == "RenderingUtils" && name.name.starts_with("ReAllocate");
    const auto handle =
        isAgain && !name.arguments.empty() ? OneArgument(name.arguments[0]) : std::nullopt;
    if (isAgain && (!handle || handle->value.type != "RTHandle"))
    {
        Fail("a target that is no RTHandle");
        return std::nullopt;
    }
    if (hasNamed && isAgain)
    {
        return NamedArguments(name.arguments);
    }
    std::vector<CSharpWords> words = name.arguments;
    const bool isAlloc = owner == "RTHandles" && name.name == "Alloc" && words.size() == 2;
    CSharpWords title = isAlloc ? words.back() : CSharpWords();
    if (isAlloc)
    {
        title = IsNamed(title) && title[0].Is("name") ? title.subspan(2) : title;
        words.pop_back(); // what an identifier stands for is called by its own name
    }
    auto arguments = Arguments(owner + "." + name.name, words);
    if (arguments && isAlloc && (*arguments)[0].value.type == "RenderTextureDescriptor")
    {
        const auto called = OneArgument(title);
        return called ? std::optional(std::vector<Argument>{
                            (*arguments)[0],
                            {{"FilterMode::Point", ""}, "FilterMode::Point"},
                            {{"TextureWrapMode::Repeat", ""}, "TextureWrapMode::Repeat"},
                            *called})
                      : std::nullopt;
    }
    const auto property = PropertyArgument(owner, name.name, arguments ? arguments->size() : 0);
    if (arguments && property && *property < arguments->size() &&
        (*arguments)[*property].value.type == "int")
    {
        Fail("a property's number that is an 'int'");
        return std::nullopt;
    }
    const std::size_t textures = name.name == "Blit" ? 3 : name.name == "SetRenderTarget" ? 2 : 0;
    for (std::size_t i = 0; arguments && i < std::min(textures, arguments->size()); ++i)
    {
        if ((*arguments)[i].value.type == "int")
        {
            Fail("a texture's number that is an 'int'");
            return std::nullopt;
        }
    }
    const auto isObject = [&](const Argument& argument)
    {
        return IsSharedType(model(), argument.value.type) || argument.value.isPointer;
    };
    if (arguments && owner == "Debug" && name.name.ends_with("Format") &&
        std::ranges::any_of(*arguments, isObject))
    {
        Fail("an object in a text");
        return std::nullopt;
    }
    if (owner == "Resources" &&
        !IsIn(name.generics, {"<Shader>", "<Texture>", "<Texture2D>", "<ComputeShader>"}))
    {
        Fail("Resources::Load of this type");
        return std::nullopt;
    }
    const bool isKeyword = arguments && owner == "CoreUtils" && name.name == "SetKeyword";
    if (isKeyword && IsIn((*arguments)[0].value.type, {"Material", "ComputeShader"}))
    {
        (*arguments)[0].text = "*" + (*arguments)[0].text;
    }
    else if (isKeyword && (*arguments)[0].value.type != "CommandBuffer")
    {
        Fail("a keyword of something that is neither a material nor global");
        return std::nullopt;
    }
    return arguments;
}

/// @param kind  of the list: 'v', 'i', 'f', 'F' or '*'
std::string PortMembers::ListText(const std::vector<Argument>& arguments, char kind) const
{
    const bool hasFloat = std::ranges::any_of(arguments, [](const Argument& one)
                                              { return one.value.type == "float"; });
    std::string text;
    for (const Argument& argument : arguments)
    {
        const std::string& type = argument.value.type;
        const bool isWhole =
            (kind == 'F' || (kind == 'f' && hasFloat)) && IsIn(type, {"int", "uint"});
        const bool isNone = kind == 'i' && argument.text == "nullptr";
        const bool isShort = kind == 'v' && (type == "Vector2" || type == "Vector3");
        const bool isTexture = kind == 'i' && IsIn(type, {"Texture", "Texture2D", "RenderTexture"});
        const bool isHandle = kind == 'i' && type == "TextureHandle";
        const std::string one =
            isWhole     ? Converted(model(), argument.value, "float")->cpp
            : isHandle  ? "RTHandle(" + argument.text + ")"
            : isShort   ? Converted(model(), argument.value, "Vector4")->cpp
            : isNone    ? std::string("RenderTargetIdentifier(BuiltinRenderTextureType::None)")
            : isTexture ? "RenderTargetIdentifier(" + argument.text + ")"
                        : argument.text;
        text += (text.empty() ? "" : ", ") + one;
    }
    return text;
}

} // namespace limn

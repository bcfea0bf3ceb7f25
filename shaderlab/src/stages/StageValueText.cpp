#include "stages/StageValueText.h"

namespace limn
{

std::string SystemType(const StageValue& value)
{
    if (value.semantic == "SV_POSITION" || value.semantic == "SV_TARGET")
    {
        return TypeName(value.semantic == "SV_TARGET" ? value.scalar : "float", 4);
    }
    if (value.semantic == "SV_ISFRONTFACE")
    {
        return "bool";
    }
    const bool isFloat = value.semantic.find("DISTANCE") != std::string::npos ||
                         value.semantic.find("DEPTH") != std::string::npos ||
                         value.semantic == "PSIZE";
    return isFloat ? "float" : "uint";
}

int ComponentsOf(const std::string& type)
{
    return type.back() >= '2' && type.back() <= '4' ? type.back() - '0' : 1;
}

std::string ConvertText(const std::string& source, int components, const std::string& scalar,
                        int wanted)
{
    const std::string type = TypeName(scalar, wanted);
    if (wanted <= components)
    {
        const std::string swizzle = std::string("xyzw").substr(0, static_cast<std::size_t>(wanted));
        return "(" + type + ")" + source + (wanted < components ? "." + swizzle : "");
    }
    std::string text = type + "(" + source;
    for (int i = components; i < wanted; ++i)
    {
        text += ", 0";
    }
    return text + ")";
}

std::string SystemSemantic(const StageValue& value)
{
    return value.semantic + (value.semantic == "SV_TARGET" ? std::to_string(value.index) : "");
}

std::string VaryingText(const Varying& varying, const std::string& name,
                        const std::string& modifiers)
{
    const std::string location = std::to_string(varying.location);
    return "[[vk::location(" + location + ")]] " + modifiers +
           TypeName(varying.scalar, varying.components) + " " + name + " : LIMN" + location;
}

} // namespace limn

#include "port/PortOperator.h"

#include "port/PortMember.h"

#include <map>

namespace limn
{

namespace
{

using Result = std::optional<PortValue>;

Result CompareToNull(const PortModel& model, const PortValue& value, bool isEqual,
                     std::string& problem)
{
    const CSharpClass* own = model.Find(value.type);
    PortValue result{"", "bool"};
    result.strength = Strength("==");
    if (value.isPointer || value.type == "RTHandle" || IsSharedType(model, value.type))
    {
        result.cpp = value.Text(result.strength) + (isEqual ? " == nullptr" : " != nullptr");
    }
    else if (value.type == "string")
    {
        result = {(isEqual ? "" : "!") + value.Text(90) + ".empty()", "bool"};
    }
    else if (own || !ElementTypeOf(value.type).empty() || IsReferenceType(model, value.type) ||
             value.type == "MaterialPropertyBlock")
    {
        result = {isEqual ? "false" : "true", "bool"}; // C++ has no null for it
    }
    else
    {
        problem = "'" + value.type + "' is compared to null";
        return std::nullopt;
    }
    return result;
}

/// Returns "a" + b or "a" == b in C++.
Result CombineText(const PortValue& left, const std::string& word, const PortValue& right,
                   std::string& problem)
{
    const auto text = [](const PortValue& value)
    {
        return value.type == "int" || value.type == "uint" ? "std::to_string(" + value.cpp + ")"
                                                           : value.Text(Strength("+"));
    };
    const auto isText = [](const PortValue& value)
    {
        return IsIn(value.type, {"string", "int", "uint"});
    };
    const bool isJoined = word == "+" && isText(left) && isText(right);
    const bool isCompared = (word == "==" || word == "!=") && left.type == right.type;
    if (!isJoined && !isCompared)
    {
        problem = "'" + left.type + " " + word + " " + right.type + "'";
        return std::nullopt;
    }
    PortValue result{(isJoined ? "std::string(" : "std::string_view(") + text(left) + ") " + word +
                         " " + text(right),
                     isJoined ? "string" : "bool"};
    result.strength = Strength(word);
    return result;
}

bool IsFlagsEnum(const std::string& type)
{
    return IsIn(type, {"CameraType", "ClearFlag", "GraphicsFormatUsage", "RenderStateMask",
                       "ScriptableRenderPassInput", "SortingCriteria"});
}

/// Returns a | b or a & b of an enum of the files, or a == 0 of a set of flags; else nothing.
Result CombineEnum(const PortModel& model, const PortValue& left, const std::string& word,
                   const PortValue& right)
{
    const CSharpClass* own = model.Find(left.type);
    const bool isOwn = own && model.RoleOf(*own) == PortRole::Enum;
    const auto number = [](const PortValue& value)
    {
        return "static_cast<int>(" + value.cpp + ")";
    };
    if (isOwn && own == model.Find(right.type) && (word == "|" || word == "&"))
    {
        const auto cpp = model.CppType(left.type);
        return cpp ? Result(PortValue{"static_cast<" + *cpp + ">(" + number(left) + " " + word +
                                          " " + number(right) + ")",
                                      left.type})
                   : std::nullopt;
    }
    const bool isZero = right.isLiteral && right.cpp == "0";
    if ((isOwn || IsFlagsEnum(left.type)) && isZero && (word == "==" || word == "!="))
    {
        PortValue value{number(left) + " " + word + " 0", "bool"};
        value.strength = Strength(word);
        return value;
    }
    return std::nullopt;
}

/// Makes a volume parameter its value, and a number beside a mask a mask.
void MakeComparable(const PortModel& model, PortValue& side, const PortValue& other)
{
    const std::string plain(PlainTypeName(side.type));
    const std::string held = plain.ends_with("Parameter") ? ParameterValueType(plain) : "";
    if (!held.empty() && !PlainTypeName(other.type).ends_with("Parameter"))
    {
        side = {side.Text(90) + (side.isPointer ? "->value()" : ".value()"), held};
    }
    if (side.type == "int" && IsIn(other.type, {"LayerMask", "RenderingLayerMask"}))
    {
        side = Converted(model, side, other.type).value_or(side);
    }
}

} // namespace

bool IsNumber(const std::string& type)
{
    return type == "int" || type == "float" || type == "uint";
}

int Strength(std::string_view word)
{
    static const std::map<std::string_view, int> strengths = {
        {"||", 1}, {"&&", 2}, {"|", 3},  {"&", 4},  {"==", 5}, {"!=", 5},
        {"<", 6},  {">", 6},  {"<=", 6}, {">=", 6}, {"<<", 7}, {">>", 7},
        {"+", 8},  {"-", 8},  {"*", 9},  {"/", 9},  {"%", 9}};
    const auto found = strengths.find(word);
    return found == strengths.end() ? 0 : found->second;
}

bool IsTruth(const PortModel& model, const PortValue& value)
{
    return value.type == "bool" || value.type.empty() || value.isPointer ||
           value.type == "RTHandle" || IsSharedType(model, value.type);
}

std::optional<PortValue> Otherwise(const PortModel& model, PortValue value, const PortValue& other)
{
    const bool isPointer = value.isPointer || IsSharedType(model, value.type);
    const Result same = Converted(model, other, value.type);
    if (!same || !isPointer || value.isPointer != other.isPointer)
    {
        return std::nullopt;
    }
    value.cpp = value.Text(1) + " ? " + value.Text(1) + " : " +
                (value.isPointer ? other.Text(0) : same->Text(0));
    value.isVariable = false;
    value.strength = 0;
    return value;
}

std::optional<PortValue> Maybe(const PortModel& model, const PortValue& value, PortValue member)
{
    if (!member.isPointer && !IsSharedType(model, member.type))
    {
        return std::nullopt;
    }
    member.cpp = value.Text(1) + " ? " + member.cpp + " : nullptr";
    member.isVariable = false;
    member.strength = 0;
    return member;
}

std::optional<PortValue> Combined(const PortModel& model, PortValue left, const std::string& word,
                                  PortValue right, std::string& problem)
{
    const int strength = Strength(word);
    const bool isComparison = strength == 5 || strength == 6;
    if (strength == 5 && (left.type == "null") != (right.type == "null"))
    {
        return CompareToNull(model, left.type == "null" ? right : left, word == "==", problem);
    }
    if (strength == 5)
    {
        MakeComparable(model, left, right);
        MakeComparable(model, right, left);
    }
    if (strength == 5 && left.type == right.type &&
        IsIn(left.type, {"GraphicsDeviceType", "CopyTextureSupport"})) // there is one device only
    {
        return PortValue{(left.cpp == right.cpp) == (word == "==") ? "true" : "false", "bool"};
    }
    if (const Result combined = CombineEnum(model, left, word, right))
    {
        return combined;
    }
    if (left.type == "string" || right.type == "string")
    {
        return CombineText(left, word, right, problem);
    }
    if (IsNumber(left.type) && IsNumber(right.type) &&
        (left.type == "float") != (right.type == "float"))
    {
        left = *Converted(model, left, "float");
        right = *Converted(model, right, "float");
    }
    const auto isVector = [](const PortValue& value)
    {
        return IsIn(value.type, {"Vector2", "Vector3", "Vector4", "Matrix4x4"});
    };
    const bool isScaled = strength >= 8 && isVector(left) != isVector(right) &&
                          IsNumber(isVector(left) ? right.type : left.type);
    if (isScaled)
    {
        PortValue& scale = isVector(left) ? right : left;
        scale = *Converted(model, scale, "float");
    }
    if (word == "*" && left.type == "Quaternion" && IsIn(right.type, {"Quaternion", "Vector3"}))
    {
        PortValue turned{left.Text(strength) + " * " + right.Text(strength + 1), right.type};
        turned.strength = strength;
        return turned;
    }
    if (word == "*" && left.type == "Matrix4x4" && IsIn(right.type, {"Vector4", "Vector3"}))
    {
        right = *Converted(model, right, "Vector4");
        PortValue turned{left.Text(strength) + " * " + right.Text(strength + 1), "Vector4"};
        turned.strength = strength;
        return turned;
    }
    const bool isUnknown = left.type.empty() || right.type.empty();
    const bool isEvent =
        left.type == "RenderPassEvent" && right.type == "int" && (word == "+" || word == "-");
    const bool isFlags =
        (word == "|" || word == "&") && left.type == right.type &&
        (IsFlagsEnum(left.type) ||
         IsIn(left.type, {"int", "uint", "ColorWriteMask", "RenderingLayerMask", "LayerMask"}));
    const bool isLogic =
        (word == "&&" || word == "||") && IsTruth(model, left) && IsTruth(model, right);
    const CSharpClass* own = model.Find(left.type);
    const bool isSame = left.type == right.type || (own && own == model.Find(right.type));
    if (isComparison && own && model.RoleOf(*own) != PortRole::Enum &&
        !(left.isPointer && right.isPointer))
    {
        problem = "'" + left.type + " " + word + " " + right.type + "'";
        return std::nullopt;
    }
    const bool isSum = strength >= 7 && isSame && (IsNumber(left.type) || isVector(left)) &&
                       !(strength == 7 && left.type == "float");
    const bool isShift = strength == 7 && left.type == "uint" && right.type == "int";
    if (word == "%" && left.type == "float")
    {
        return PortValue{"std::fmod(" + left.cpp + ", " + right.cpp + ")", "float"};
    }
    if (!isEvent && !isFlags && !isLogic && !isSum && !isScaled && !isUnknown && !isShift &&
        !(isComparison && isSame && left.type != "null"))
    {
        problem = "'" + left.type + " " + word + " " + right.type + "'";
        return std::nullopt;
    }
    const bool isMixed = isLogic && word == "||"; // compilers warn of a && b || c
    const auto side = [&](const PortValue& value, int least)
    {
        return value.isPointer && !isLogic ? "*" + value.Text(90)
                                           : value.Text(isMixed && value.strength == 2 ? 3 : least);
    };
    PortValue result{side(left, strength) + " " + word + " " + side(right, strength + 1),
                     isComparison || isLogic       ? "bool"
                     : isScaled && isVector(right) ? right.type
                                                   : left.type};
    result.type = isUnknown && !isComparison && !isLogic ? "" : result.type;
    result.strength = strength;
    return result;
}

} // namespace limn

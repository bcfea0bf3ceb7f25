#pragma once

#include "port/PortExpression.h"

#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// A name in C#, and what stands behind it.
struct PortName
{
    std::string name;
    std::string generics; ///< "<Bloom>"; "" if there are none
    bool isCall = false;
    std::vector<CSharpWords> arguments; ///< those of the call
    bool isTarget = false;              ///< true if it is assigned to
    bool isOfThis = false;              ///< true behind `this.`
};

/// Finds what names of C# are in C++: members of the files' classes, and those of Unity's types by
/// porting.txt. A member whose C++ differs has its code there:
///
///     cpp KEY ... = CODE       and   cpp KEY ... := CODE   of an assignment
///
/// In it, @ is the object with its dot or arrow, $& the object, % the name with its type arguments,
/// $1 the first argument, $p1 the same as a pointer, $1:Type the same as a value of that type, $*
/// all, $v* all with vectors of four, $i* all with textures as identifiers, $f* all as floats if
/// one is a float, $F* all as floats. A result of type N is a float if an argument is one, else
/// what the first one is. For two arguments it is "cpp KEY/2 = CODE". The code `=` is the same
/// line, and `-` is none at all. "names KEY = a b=CODE" are the names of its parameters, which a
/// call may have before its arguments, with the C++ of those that it may leave out.
class PortMembers
{
public:
    /// @param problem  becomes the reason of a result that is nothing
    PortMembers(const PortPlace& place, std::string& problem) : m_Place(place), m_Problem(problem)
    {
    }

    /// Returns what the name alone means in the class of the PortContext.
    std::optional<PortValue> Find(const PortName& name) const;
    /// Returns value.name, or Type.name.
    std::optional<PortValue> MemberOf(const PortValue& value, const PortName& name) const;
    /// Returns base.name, or the name alone that the class has from its base.
    std::optional<PortValue> BaseMember(const PortName& name, bool isExplicit) const;
    /// Returns value[index].
    std::optional<PortValue> Element(const PortValue& value, CSharpWords index) const;
    /// Returns `new type(arguments)`.
    std::optional<PortValue> Construct(const std::string& type,
                                       const std::vector<CSharpWords>& arguments) const;
    /// Returns the C++ code that assigns a value to a member that C++ has no variable for, or
    /// nothing if there is no such code.
    std::optional<std::string> Setter(const PortValue& value, const PortName& name,
                                      CSharpWords assigned) const;

private:
    struct Argument
    {
        PortValue value;
        std::string text; ///< the object itself where the value is a pointer
    };
    using Result = std::optional<PortValue>;

    Result Fail(const std::string& problem) const;
    const PortModel& model() const { return m_Place.model; }
    Result OwnMember(const PortValue& value, const CSharpClass& own, const PortName& name) const;
    std::string TypeFromOutside(const std::string& type) const;
    Result OwnField(const std::string& access, const CSharpClass& own, const CSharpField& field,
                    bool isVariable) const;
    Result OwnCall(const std::string& access, const CSharpClass& own, const PortName& name) const;
    Result UnityMember(const PortValue& value, const std::string& access,
                       const PortName& name) const;
    std::optional<std::vector<Argument>> ArgumentsOf(const std::string& owner,
                                                     const PortName& name) const;
    Result ListMember(const PortValue& value, const PortName& name) const;
    Result ParameterMember(const PortValue& value, const PortName& name) const;
    std::optional<std::string> TypeArguments(const std::string& generics) const;
    std::optional<Argument> OneArgument(CSharpWords words) const;
    std::optional<std::vector<Argument>> Arguments(const std::string& key,
                                                   const std::vector<CSharpWords>& words) const;
    std::optional<std::vector<Argument>>
    OrderedArguments(const std::vector<PortParameter>& names,
                     const std::vector<CSharpWords>& words) const;
    std::optional<std::vector<Argument>>
    NamedArguments(const std::vector<CSharpWords>& words) const;
    std::string ListText(const std::vector<Argument>& arguments, char kind) const;
    std::optional<std::string> FillIn(std::string_view code, const PortValue& value,
                                      const std::string& access, const std::string& name,
                                      const std::vector<Argument>& arguments) const;

    PortPlace m_Place;
    std::string& m_Problem;
};

/// Returns an argument of one of the files' own methods in C++, or nothing if it is not known.
std::optional<std::string> PortArgument(const PortPlace& place, const CSharpClass& owner,
                                        const CSharpParameter& parameter, CSharpWords words,
                                        std::string& problem);
/// Returns "std::make_unique<P>(a, b)" of `new P(a, b)`, or nothing if it is not known.
std::optional<std::string> MakePass(const PortPlace& place, const CSharpClass& pass,
                                    const std::vector<CSharpWords>& arguments,
                                    std::string& problem);

/// Returns the class of Unity from which a class of this role derives in the end; "" for none.
std::string BaseTypeOf(PortRole role);

/// Returns the type of the value of a volume parameter that Unity has, by the parameter's name:
/// "float" for ClampedFloatParameter; "" for others.
std::string ParameterValueType(const std::string& parameter);

/// Returns the type of the elements of a list or an array; "" for others.
std::string ElementTypeOf(const std::string& type);

/// Returns whether C++ keeps objects of this type behind a pointer of its own: Material.
bool IsSharedType(const PortModel& model, const std::string& type);

/// Returns whether a variable of this type is another name of the object, and no copy of it.
bool IsReferenceType(const PortModel& model, const std::string& type);

} // namespace limn

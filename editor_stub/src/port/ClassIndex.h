#pragma once

#include "port/csharp/CSharpFile.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace limn
{

using CSharpFiles = std::vector<std::unique_ptr<CSharpFile>>;

/// The classes of C# files by name, as C# finds them: what is in a class has to be called by its
/// name outside of it.
class ClassIndex
{
public:
    /// @param files      must outlive this
    /// @param isOfUnity  whether Unity has a type of this name
    ClassIndex(const CSharpFiles& files, std::function<bool(std::string_view)> isOfUnity);

    /// Nested ones behind the one that they are in.
    const std::vector<const CSharpClass*>& all() const { return m_All; }
    const CSharpClass* OuterOf(const CSharpClass& one) const { return m_Outer.at(&one); }

    /// What the type is called there; null where the files have none.
    /// @param context  null = outside of all classes
    const CSharpClass* Find(std::string_view type, const CSharpClass* context) const;

private:
    void Add(const std::vector<CSharpClass>& classes, const CSharpClass* outer);
    bool isVisible(const CSharpClass& one, const CSharpClass* context) const;

    std::vector<const CSharpClass*> m_All;
    std::map<const CSharpClass*, const CSharpClass*> m_Outer;
    std::multimap<std::string, const CSharpClass*, std::less<>> m_ByName;
    std::function<bool(std::string_view)> m_IsOfUnity;
};

} // namespace limn

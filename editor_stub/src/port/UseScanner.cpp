#include "port/UseScanner.h"
#include "port/csharp/CSharpTokens.h"

#include <algorithm>

namespace limn
{

namespace
{

bool IsBuiltinType(std::string_view word)
{
    return IsIn(word, {"int",  "uint",    "float", "double",  "bool",   "string", "object",
                       "void", "byte",    "sbyte", "short",   "ushort", "long",   "ulong",
                       "char", "decimal", "var",   "dynamic", "nint",   "nuint"});
}

bool IsGenericName(std::string_view word)
{
    return word == "T" || (word.size() > 1 && word[0] == 'T' && word[1] >= 'A' && word[1] <= 'Z' &&
                           word.size() < 12 && word.find("Handle") == std::string_view::npos);
}

std::string_view BaseOf(std::string_view type)
{
    if (IsIn(type, {"Texture2D", "Texture3D", "Cubemap", "RenderTexture"}))
    {
        return "Texture";
    }
    if (IsIn(type, {"Material", "Shader", "Texture", "Mesh", "GameObject",
                    "ScriptableRendererFeature", "VolumeComponent"}))
    {
        return "Object";
    }
    if (type == "UniversalRenderer")
    {
        return "ScriptableRenderer";
    }
    return type.ends_with("Parameter") && type != "VolumeParameter" ? "VolumeParameter" : "";
}

/// Types and attributes that C# and its tools have, for whoever reads.
bool IsOfTools(std::string_view name)
{
    return IsIn(name, {"UsedImplicitly", "Obsolete", "Conditional", "MethodImpl", "NotNull",
                       "CanBeNull", "SuppressMessage", "EditorBrowsable", "Flags"});
}

/// The parts of a class one by one.
class ClassScan
{
public:
    explicit ClassScan(UseScanner& scanner) : m_Scanner(scanner) {}

    void Scan(const CSharpClass& one)
    {
        m_Scanner.Enter(one);
        for (const std::string& base : one.bases)
        {
            m_Scanner.UseType(base, one.location);
        }
        for (const CSharpField& field : one.fields)
        {
            ScanField(field);
        }
        for (const CSharpEnumerator& enumerator : one.enumerators)
        {
            m_Scanner.ScanWords(enumerator.value);
        }
        for (const CSharpMethod& method : one.methods)
        {
            ScanMethod(one, method);
        }
        for (const CSharpClass& nested : one.classes)
        {
            Scan(nested);
        }
        m_Scanner.Leave();
    }

private:
    void ScanField(const CSharpField& field)
    {
        m_Scanner.UseType(field.type, field.location);
        for (const CSharpAttribute& attribute : field.attributes)
        {
            m_Scanner.UseAttribute(attribute.name, field.location);
        }
        m_Scanner.BeginMethod();
        m_Scanner.ScanWords(field.value);
    }

    void ScanMethod(const CSharpClass& one, const CSharpMethod& method)
    {
        m_Scanner.BeginMethod();
        m_Scanner.UseType(method.type, method.location);
        for (const CSharpParameter& parameter : method.parameters)
        {
            m_Scanner.UseType(parameter.type, method.location);
            m_Scanner.Declare(parameter.name, parameter.type);
        }
        if (method.isOverride)
        {
            m_Scanner.UseOverride(one, method);
        }
        m_Scanner.ScanWords(method.base);
        m_Scanner.ScanWords(method.body);
    }

    UseScanner& m_Scanner;
};

} // namespace

UseScanner::UseScanner(const CSharpFiles& files, const PortingTable& table)
    : m_Table(table), m_Own(files, [&table](std::string_view type) { return table.HasType(type); })
{
    for (const CSharpClass* one : m_Own.all())
    {
        for (const auto& [name, index] : one->methodNames)
        {
            if (one->isStatic && !one->methods[index].parameters.empty())
            {
                m_Extensions.emplace(name, &one->methods[index]);
            }
        }
    }
}

void UseScanner::Use(const std::string& key, const PortEntry* entry, const SourceLocation& location,
                     const std::string& problem)
{
    if (m_IsSilent)
    {
        return;
    }
    UsedMember& use = m_Uses[(entry ? "0" : "1") + key];
    use.key = key;
    use.entry = entry;
    use.problem = use.problem.empty() ? problem : use.problem;
    const bool isThere = !use.places.empty() && use.places.back().file == m_File &&
                         use.places.back().location == location;
    if (!isThere)
    {
        use.places.push_back({m_File, location});
    }
}

std::vector<UsedMember> UseScanner::TakeUses()
{
    std::vector<UsedMember> uses;
    for (auto& [key, use] : m_Uses)
    {
        uses.push_back(std::move(use));
    }
    m_Uses.clear();
    return uses;
}

const CSharpClass* UseScanner::FindClass(std::string_view type) const
{
    return m_Own.Find(type, m_Classes.empty() ? nullptr : m_Classes.back());
}

void UseScanner::UseType(std::string_view type, const SourceLocation& location)
{
    for (std::size_t at = 0; at < type.size();)
    {
        const std::size_t end = std::min(type.find_first_of("<>,[]()*", at), type.size());
        const std::string_view name = type.substr(at, end - at);
        at = end + 1;
        if (name.empty() || name == "..." || IsBuiltinType(name) || IsGenericName(name))
        {
            continue;
        }
        const std::string_view last = name.substr(name.rfind('.') + 1);
        if (FindClass(name) || FindClass(name.substr(0, name.find('.'))))
        {
            continue;
        }
        const std::string key(m_Table.Find(name) ? name : last);
        const PortEntry* entry = m_Table.Find(key);
        Use(key, entry, location, entry ? "" : "a type that the table does not have");
    }
}

void UseScanner::UseAttribute(const std::string& name, const SourceLocation& location)
{
    if (!IsOfTools(name))
    {
        const PortEntry* entry = m_Table.Find("[" + name + "]");
        Use("[" + name + "]", entry, location,
            entry ? "" : "an attribute that the table does not have");
    }
}

const PortEntry* UseScanner::FindInherited(std::string_view type, std::string_view member,
                                           std::string& owner) const
{
    for (std::string_view at = type; !at.empty(); at = BaseOf(at))
    {
        if (const PortEntry* entry = m_Table.Find(at, member))
        {
            owner = at;
            return entry;
        }
    }
    return nullptr;
}

void UseScanner::UseOverride(const CSharpClass& one, const CSharpMethod& method)
{
    if (method.name == "ToString" || method.name == "Equals" || method.name == "GetHashCode")
    {
        return;
    }
    std::string owner;
    for (const std::string& base : one.bases)
    {
        if (FindClass(base))
        {
            return; // overrides what the files define
        }
        if (const PortEntry* entry = FindInherited(PlainTypeName(base), method.name, owner))
        {
            Use(owner + "." + method.name, entry, method.location);
            return;
        }
    }
    Use(one.name + "." + method.name, nullptr, method.location,
        "overrides what the table does not have");
}

bool UseScanner::isOwnMember(const CSharpClass& one, const std::string& name, std::string& type,
                             int depth) const
{
    if (const CSharpField* field = one.FindField(name))
    {
        type = field->type;
        return true;
    }
    if (const CSharpMethod* method = one.FindMethod(name))
    {
        type = method->type;
        return true;
    }
    const bool isEnumerator = one.enumeratorNames.contains(name);
    const bool isNested = one.classNames.contains(name);
    type = isEnumerator ? one.name : one.name + "." + name;
    if (isEnumerator || isNested)
    {
        return true;
    }
    constexpr int k_MaxBases = 20; // of classes that derive from each other
    return depth < k_MaxBases &&
           std::ranges::any_of(one.bases,
                               [&](const std::string& base)
                               {
                                   const CSharpClass* own = FindClass(base);
                                   return own && own != &one &&
                                          isOwnMember(*own, name, type, depth + 1);
                               });
}

/// Returns the types from which a class derives in the end, through other classes of the files.
std::vector<std::string> UseScanner::BasesOf(const CSharpClass& one, int depth) const
{
    constexpr int k_MaxBases = 20; // of classes that derive from each other
    std::vector<std::string> bases;
    for (const std::string& base : one.bases)
    {
        const CSharpClass* own = FindClass(base);
        if (own && own != &one && depth < k_MaxBases)
        {
            const auto inherited = BasesOf(*own, depth + 1);
            bases.insert(bases.end(), inherited.begin(), inherited.end());
        }
        else
        {
            bases.emplace_back(PlainTypeName(base));
        }
    }
    return bases;
}

/// A method of a static class of the files that any object may be asked for; null = none.
const CSharpMethod* UseScanner::FindExtension(std::string_view name) const
{
    const auto found = m_Extensions.find(name);
    return found == m_Extensions.end() ? nullptr : found->second;
}

/// @return what the member gives
std::string UseScanner::MemberOf(const std::string& type, Word member, const std::string& generics)
{
    const std::string name(member->text);
    std::string owner;
    std::string result;
    std::string_view plain = PlainTypeName(type);
    const CSharpClass* own = FindClass(type);
    if (own && isOwnMember(*own, name, result))
    {
        return result;
    }
    std::vector<std::string> bases{std::string(type.ends_with("[]") ? "[]" : plain)};
    if (own)
    {
        bases = BasesOf(*own);
    }
    for (const std::string& base : bases)
    {
        if (const PortEntry* entry = FindInherited(base, name, owner))
        {
            Use(owner + "." + name, entry, member->location);
            if (entry->result == "T" && !generics.empty())
            {
                return generics.substr(1, generics.size() - 2);
            }
            return entry->result.empty() ? k_UnknownType : entry->result;
        }
    }
    if (const CSharpMethod* extension = FindExtension(name))
    {
        return extension->type;
    }
    if (type == k_UnknownType)
    {
        Use("(...)." + name, nullptr, member->location,
            "a member of something whose type the scanner cannot tell");
    }
    else
    {
        Use(std::string(plain) + "." + name, nullptr, member->location,
            "a member that the table does not have");
    }
    return k_UnknownType;
}

/// .a.b(c)[d] behind something of this type; `at` then stands behind it.
std::string UseScanner::FollowChain(std::string type, Word& at, Word end)
{
    while (at < end)
    {
        if (at->Is("(") && at->match > 0)
        {
            at += at->match + 1;
        }
        else if (at->Is("[") && at->match > 0)
        {
            type = type == k_UnknownType ? type : ElementType(type);
            at += at->match + 1;
        }
        else if (at->Is("!") && at + 1 < end && at[1].Is("."))
        {
            ++at;
        }
        else if ((at->Is(".") || at->Is("?.")) && at + 1 < end && at[1].isName())
        {
            const Word member = ++at;
            m_Done.insert(member);
            ++at;
            std::string generics;
            if (at < end && at->Is("<"))
            {
                generics = ReadCSharpGenerics(at);
                UseType(generics, member->location);
            }
            type = MemberOf(type, member, generics);
            if (IsIn(member->text, {"AddRasterRenderPass", "AddUnsafePass", "AddComputePass"}))
            {
                m_PassData =
                    generics.empty() ? k_UnknownType : generics.substr(1, generics.size() - 2);
                m_PassContext = member->text == "AddUnsafePass"         ? "UnsafeGraphContext"
                                : member->text == "AddRasterRenderPass" ? "RasterGraphContext"
                                                                        : "ComputeGraphContext";
            }
        }
        else
        {
            break;
        }
    }
    return type;
}

/// Returns the type of the value that begins there, if it can be known.
std::string UseScanner::TypeOfValue(Word at, Word end)
{
    const bool wasSilent = m_IsSilent;
    m_IsSilent = true;
    at += at < end && at->Is("ref") ? 1 : 0; // ref var a = ref b
    std::string type = k_UnknownType;
    if (at < end && at->Is("new"))
    {
        Word behind = at + 1;
        type = behind->Is("(") ? "" : ReadCSharpType(behind);
        type = type.empty() ? k_UnknownType : type;
    }
    else if (at < end && at->isName() && !IsCSharpKeyword(at->text))
    {
        type = TypeOfHead(at);
        Word behind = at + 1;
        type = FollowChain(type, behind, end);
        if (behind < end && behind->Is("as"))
        {
            type = ReadCSharpType(++behind);
        }
    }
    m_IsSilent = wasSilent;
    return type;
}

/// Returns the type of a name at the beginning of a chain.
std::string UseScanner::TypeOfHead(Word word)
{
    const std::string name(word->text);
    const auto local = m_Locals.find(name);
    if (local != m_Locals.end())
    {
        return local->second;
    }
    if (name == "this" && !m_Classes.empty())
    {
        return m_Classes.back()->name;
    }
    if (name == "base" && !m_Classes.empty() && !m_Classes.back()->bases.empty())
    {
        return m_Classes.back()->bases.front();
    }
    std::string type;
    std::string owner;
    for (auto one = m_Classes.rbegin(); one != m_Classes.rend(); ++one)
    {
        if (isOwnMember(**one, name, type))
        {
            return type;
        }
        for (const std::string& base : (*one)->bases)
        {
            const PortEntry* entry = FindInherited(PlainTypeName(base), name, owner);
            if (entry && m_Table.Find(owner + "." + name))
            {
                Use(owner + "." + name, entry, word->location);
                return entry->result.empty() ? k_UnknownType : entry->result;
            }
        }
    }
    if (FindClass(name) || IsBuiltinType(name) || IsGenericName(name))
    {
        return name;
    }
    if (m_Table.HasType(name))
    {
        if (const PortEntry* entry = m_Table.Find(name))
        {
            Use(name, entry, word->location);
        }
        return name;
    }
    Use(name, nullptr, word->location, "a name that neither the files nor the table have");
    return k_UnknownType;
}

std::vector<UsedMember> UsedMembersOf(const CSharpFiles& files, const PortingTable& table)
{
    UseScanner scanner(files, table);
    for (const auto& file : files)
    {
        scanner.SetFile(*file);
        for (const CSharpClass& one : file->classes)
        {
            ClassScan(scanner).Scan(one);
        }
    }
    return scanner.TakeUses();
}

} // namespace limn

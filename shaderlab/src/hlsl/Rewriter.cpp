#include "hlsl/Rewriter.h"

#include <limn/shaderlab/UnsupportedProgramError.h>

#include "hlsl/Repeats.h"
#include "stages/GeometryEntryWriter.h"
#include "stages/KernelEntryWriter.h"
#include "text/Text.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace limn
{

namespace
{

constexpr std::array<std::string_view, 11> k_Assignments = {
    "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
constexpr std::string_view k_DrawIndex = "limn_DrawIndex";

constexpr std::string_view k_StandIn = "[limn_Lacks";

/// What `[limn_Lacks("X", "Y")]` says.
std::string DescribeStandIn(std::string_view attribute)
{
    std::vector<std::string> parts; // what is outside and inside of quotes in turn
    while (parts.size() < 4)
    {
        const std::size_t size = std::min(attribute.find('"'), attribute.size());
        parts.emplace_back(attribute.substr(0, size));
        attribute.remove_prefix(std::min(size + 1, attribute.size()));
    }
    return "uses " + parts[1] + ", which limn does not have: " + parts[3];
}

class Rewriter
{
public:
    Rewriter(const HlslSource& source, std::string_view entry)
        : m_Source(source), m_Tokens(source.tokens)
    {
        MarkFunctions();
        FindReachable(entry);
    }

    /// What only compute shaders do in limn.
    void RefuseWritable() const
    {
        for (const HlslVariable& object : m_Source.declarations.objects)
        {
            if (isWritable(object.type) && isReached(object.name))
            {
                const std::size_t offset = m_Tokens[object.token].Begin(m_Source.text);
                const HlslPlace place = PlaceOf(m_Source.text, offset);
                throw UnsupportedProgramError(
                    {Severity::Error, place.file, place.location,
                     "'" + std::string(object.name) + "': a " + std::string(object.type) +
                         " can be written to, which limn does in compute shaders only; its passes "
                         "read textures and buffers"});
            }
        }
    }

    /// glslang crashes on them.
    void RefuseBoolMatrices() const
    {
        ForEachToken(
            [&](std::size_t i, const HlslStruct*)
            {
                const std::string_view word = Text(i);
                if (word.size() == 7 && word.starts_with("bool") && word[5] == 'x')
                {
                    const HlslPlace place =
                        PlaceOf(m_Source.text, m_Tokens[i].Begin(m_Source.text));
                    throw AssetError(place.file, place.location,
                                     "'" + std::string(word) +
                                         "': limn has no matrices of bool; use 'float" +
                                         std::string(word.substr(4)) + "'");
                }
            });
    }

    void CopyAssignedUniforms()
    {
        std::map<std::string_view, const HlslVariable*> uniforms;
        for (const HlslVariable& uniform : m_Source.declarations.uniforms)
        {
            uniforms[uniform.name] = &uniform;
        }
        ForEachToken(
            [&](std::size_t i, const HlslStruct* owner)
            {
                const auto uniform = uniforms.find(m_Tokens[i].text);
                if (uniform != uniforms.end() && !hasMember(owner, uniform->first) &&
                    (isAssigned(i) || isOutArgument(i)))
                {
                    m_Copied.insert(uniform->second);
                }
            });
        for (const HlslVariable* uniform : m_Copied)
        {
            Copy(*uniform);
        }
    }

    /// As macros leave them that end in a `;` or are empty.
    void RemoveEmptyMembers()
    {
        for (const std::size_t token : m_Source.declarations.emptyMembers)
        {
            m_Renamed[token] = "";
        }
    }

    void RemoveRepeatedDeclarations()
    {
        for (const HlslVariable* variable : FindRepeats(m_Source.declarations).superfluous)
        {
            Remove(*variable);
        }
    }

    /// Textures and the like are no members of a buffer to glslang, though HLSL lets them stand
    /// there.
    void MoveObjectsOutOfBuffers()
    {
        for (const HlslVariable& object : m_Source.declarations.objects)
        {
            if (!object.isInBuffer || object.lastToken == 0)
            {
                continue;
            }
            std::string moved;
            for (std::size_t i = object.firstToken; i <= object.lastToken; ++i)
            {
                moved.append(" ").append(Text(i));
            }
            Remove(object);
            const std::size_t end = object.endToken;
            m_InsertedAfter[Text(end + 1) == ";" ? end + 1 : end] += moved;
        }
    }

    /// Makes an ordinary function of the author's geometry function; see GeometryEntryWriter.h.
    void TakeGeometryApart(const StageInterface& interface, const StageLinkage& linkage)
    {
        std::size_t first = interface.function->begin;
        for (const HlslFunction* function : m_Reachable)
        {
            for (std::size_t i = function->begin; i < function->end; ++i)
            {
                const bool isAppend = Text(i) == "Append" && Text(i - 1) == ".";
                if (isAppend)
                {
                    m_InsertedAfter[i + 1] += std::string(k_PackFunction) + "(";
                    m_Renamed[BehindBracket(i + 1, "(", ")") - 1] = "))";
                }
                else if (isStream(Text(i)) && Text(i + 1) == "<")
                {
                    m_Renamed[i + 2] = k_GeometryOutput;
                }
                else if (Text(i) == interface.geometry->primitive)
                {
                    m_Renamed[i] = "";
                }
                first = isAppend || isStream(Text(i)) ? std::min(first, function->begin) : first;
            }
        }
        if (first > 0)
        {
            m_InsertedAfter[first - 1] += " " + WriteGeometryTypes(interface, linkage);
        }
    }

    /// Whether the stage's functions name it.
    bool isReached(std::string_view name) const
    {
        return std::any_of(m_Reachable.begin(), m_Reachable.end(),
                           [&](const HlslFunction* item)
                           {
                               return std::any_of(m_Tokens.begin() + Offset(item->begin),
                                                  m_Tokens.begin() + Offset(item->end),
                                                  [&](const HlslToken& token)
                                                  { return token.text == name; });
                           });
    }

    /// Takes the marks off, which are no HLSL, and tells what those of reached functions say.
    void TakeStandIns(std::vector<std::string>* standIns)
    {
        for (const HlslFunction* function : m_Reachable)
        {
            for (const std::string_view attribute : function->attributes)
            {
                if (attribute.starts_with(k_StandIn))
                {
                    Erase(function->begin, attribute);
                    if (standIns != nullptr)
                    {
                        standIns->push_back(DescribeStandIn(attribute));
                    }
                }
            }
        }
    }

    /// Those of an entry function stand before the generated one.
    void TakeAttributes(const HlslFunction& function)
    {
        for (const std::string_view attribute : function.attributes)
        {
            Erase(function.begin, attribute);
        }
    }

    const std::string& prologue() const { return m_Prologue; }

    /// The source with everything applied. Blanks and directives between tokens stay as they are.
    std::string Assemble() const
    {
        const std::string_view text = m_Source.text;
        std::string result;
        result.reserve(text.size());
        std::size_t position = 0;
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            const std::size_t begin = m_Tokens[i].Begin(text);
            result.append(text.substr(position, begin - position));
            position = begin + m_Tokens[i].text.size();
            const HlslFunction* function = m_FunctionOf[i];
            if (!function || m_Reachable.count(function) > 0)
            {
                const auto renamed = m_Renamed.find(i);
                result.append(renamed == m_Renamed.end() ? m_Tokens[i].text : renamed->second);
            }
            if (const auto inserted = m_InsertedAfter.find(i); inserted != m_InsertedAfter.end())
            {
                result.append(inserted->second);
            }
        }
        return result.append(text.substr(position));
    }

private:
    static bool isWritable(std::string_view type)
    {
        return type.substr(0, 2) == "RW" || type.substr(0, 17) == "RasterizerOrdered" ||
               type == "AppendStructuredBuffer" || type == "ConsumeStructuredBuffer";
    }

    /// Calls a function with each token of reached functions and, with their struct, of methods.
    template <typename F>
    void ForEachToken(F&& each) const
    {
        const auto visit = [&](const HlslFunction& function, const HlslStruct* owner)
        {
            for (std::size_t i = function.begin; i < function.end; ++i)
            {
                each(i, owner);
            }
        };
        for (const HlslFunction* function : m_Reachable)
        {
            visit(*function, nullptr);
        }
        for (const HlslStruct& owner : m_Source.declarations.structs)
        {
            for (const HlslFunction& method : owner.methods)
            {
                visit(method, &owner);
            }
        }
    }

    /// In methods, members hide uniforms.
    static bool hasMember(const HlslStruct* owner, std::string_view name)
    {
        return owner &&
               std::any_of(owner->members.begin(), owner->members.end(),
                           [&](const HlslVariable& member) { return member.name == name; });
    }

    static std::ptrdiff_t Offset(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

    void MarkFunctions()
    {
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            if (const std::string name = AuthorFunctionName(Text(i)); name != Text(i))
            {
                m_Renamed[i] = name;
            }
        }
        m_FunctionOf.resize(m_Tokens.size(), nullptr);
        for (const HlslFunction& function : m_Source.declarations.functions)
        {
            m_ByName[function.name].push_back(&function);
            m_Called[function.name].push_back(&function);
            std::fill(m_FunctionOf.begin() + Offset(function.begin),
                      m_FunctionOf.begin() + Offset(function.end), &function);
        }
        for (const HlslStruct& type : m_Source.declarations.structs)
        {
            for (const HlslFunction& method : type.methods)
            {
                m_Called[method.name].push_back(&method);
            }
        }
    }

    void FindReachable(std::string_view entry)
    {
        Reach(entry);
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            if (!m_FunctionOf[i])
            {
                Reach(m_Tokens[i].text);
            }
        }
    }

    /// All overloads of a name at once: which one is called is not for us to find out.
    void Reach(std::string_view name)
    {
        std::vector<std::string_view> pending = {name};
        while (!pending.empty())
        {
            const auto found = m_ByName.find(pending.back());
            pending.pop_back();
            if (found == m_ByName.end())
            {
                continue;
            }
            for (const HlslFunction* function : found->second)
            {
                if (m_Reachable.insert(function).second)
                {
                    for (std::size_t i = function->begin; i < function->end; ++i)
                    {
                        pending.push_back(m_Tokens[i].text);
                    }
                }
            }
        }
    }

    /// Erases the tokens of `span`, from `token` on.
    void Erase(std::size_t token, std::string_view span)
    {
        for (; Text(token).data() < span.data() + span.size(); ++token)
        {
            if (Text(token).data() >= span.data())
            {
                m_Renamed[token] = "";
            }
        }
    }

    void Remove(const HlslVariable& variable)
    {
        for (std::size_t i = variable.firstToken; i <= variable.lastToken; ++i)
        {
            m_Renamed[i] = "";
        }
    }

    std::string_view Text(std::size_t index) const
    {
        return index < m_Tokens.size() ? m_Tokens[index].text : std::string_view();
    }

    bool isAssigned(std::size_t index) const
    {
        const std::string_view before = Text(index - 1);
        const bool isBehindWord =
            index > 0 && m_Tokens[index - 1].isWord && before != "return" && before != "else";
        if (before == "." || isBehindWord)
        {
            return false; // a member of something else, or the declaration of a local
        }
        if (before == "++" || before == "--")
        {
            return true;
        }
        std::size_t next = index + 1;
        while (Text(next) == "." || Text(next) == "[")
        {
            next = Text(next) == "." ? next + 2 : BehindBracket(next, "[", "]");
        }
        const std::string_view mark = Text(next);
        return mark == "++" || mark == "--" ||
               std::find(k_Assignments.begin(), k_Assignments.end(), mark) != k_Assignments.end();
    }

    /// Whether it stands for a parameter that the function called writes to, by itself.
    bool isOutArgument(std::size_t index) const
    {
        std::size_t position = 0;
        std::size_t open = index;
        if (Text(index - 1) != "(" && Text(index - 1) != ",")
        {
            return false;
        }
        for (int depth = 0; open > 0 && depth <= 0;)
        {
            const std::string_view text = Text(--open);
            if (text == ";" || text == "{" || text == "}")
            {
                return false;
            }
            depth += text == "(" || text == "[" ? 1 : text == ")" || text == "]" ? -1 : 0;
            position += text == "," && depth == 0 ? 1 : 0;
        }
        const auto functions = open > 0 ? m_Called.find(Text(open - 1)) : m_Called.end();
        return functions != m_Called.end() &&
               std::any_of(functions->second.begin(), functions->second.end(),
                           [&](const HlslFunction* function)
                           {
                               const auto& parameters = function->parameters;
                               return position < parameters.size() &&
                                      (parameters[position].Has("out") ||
                                       parameters[position].Has("inout"));
                           });
    }

    std::size_t BehindBracket(std::size_t index, std::string_view open,
                              std::string_view close) const
    {
        int depth = 0;
        do
        {
            depth += Text(index) == open ? 1 : 0;
            depth -= Text(index) == close ? 1 : 0;
            ++index;
        } while (depth > 0 && index < m_Tokens.size());
        return index;
    }

    void Copy(const HlslVariable& uniform)
    {
        const std::string copy = "limn_copy" + std::string(uniform.name);
        std::string& inserted = m_InsertedAfter[uniform.endToken];
        inserted += " static " + std::string(uniform.type) + " " + copy;
        for (const std::string_view size : uniform.dimensions)
        {
            inserted += "[" + std::string(size) + "]";
        }
        inserted += ";";
        m_Prologue += copy + " = " + std::string(uniform.name) + ";\n";
        ForEachToken(
            [&](std::size_t i, const HlslStruct* owner)
            {
                if (Text(i) == uniform.name && Text(i - 1) != "." &&
                    !hasMember(owner, uniform.name))
                {
                    m_Renamed[i] = copy;
                }
            });
    }

    const HlslSource& m_Source;
    const std::vector<HlslToken>& m_Tokens;
    std::vector<const HlslFunction*> m_FunctionOf; ///< by token; null at file scope
    std::map<std::string_view, std::vector<const HlslFunction*>> m_ByName;
    std::map<std::string_view, std::vector<const HlslFunction*>> m_Called; ///< methods as well
    std::set<const HlslFunction*> m_Reachable;
    std::set<const HlslVariable*> m_Copied;
    std::map<std::size_t, std::string> m_Renamed;       ///< token index → new text
    std::map<std::size_t, std::string> m_InsertedAfter; ///< token index → text
    std::string m_Prologue;
};

} // namespace

HlslSource::HlslSource(std::string preprocessed)
    : text(std::move(preprocessed)),
      tokens(TokenizeHlsl(text)),
      declarations(ReadDeclarations(tokens))
{
}

std::string RewriteStage(const HlslSource& source, ShaderStage stage,
                         const StageInterface& interface, const StageLinkage& linkage,
                         std::vector<std::string>* standIns)
{
    Rewriter rewriter(source, interface.function->name);
    rewriter.TakeStandIns(standIns);
    rewriter.RefuseWritable();
    rewriter.RefuseBoolMatrices();
    rewriter.RemoveEmptyMembers();
    rewriter.RemoveRepeatedDeclarations();
    rewriter.MoveObjectsOutOfBuffers();
    rewriter.CopyAssignedUniforms();
    if (interface.geometry)
    {
        rewriter.TakeGeometryApart(interface, linkage);
    }
    return rewriter.Assemble() + WriteEntryPoint(interface, linkage, stage, rewriter.prologue(),
                                                 rewriter.isReached(k_DrawIndex));
}

std::string RewriteKernel(const HlslSource& source, const HlslFunction& kernel,
                          std::vector<std::string>* standIns)
{
    const auto fail = [&](const std::string& message)
    {
        const HlslPlace place =
            PlaceOf(source.text, source.tokens[kernel.begin].Begin(source.text));
        throw AssetError(place.file, place.location,
                         "'" + std::string(kernel.name) + "': " + message);
    };
    if (ThreadsOf(kernel).empty())
    {
        fail("a kernel says how many threads a group has; write '[numthreads(8, 8, 1)]' before it");
    }
    Rewriter rewriter(source, kernel.name);
    if (rewriter.isReached(k_DrawIndex))
    {
        fail("it reads what each draw has of its own, such as unity_ObjectToWorld; a kernel draws "
             "nothing, so give it the value as a parameter");
    }
    rewriter.TakeStandIns(standIns);
    rewriter.RefuseBoolMatrices();
    rewriter.RemoveEmptyMembers();
    rewriter.RemoveRepeatedDeclarations();
    rewriter.MoveObjectsOutOfBuffers();
    rewriter.CopyAssignedUniforms();
    rewriter.TakeAttributes(kernel);
    return rewriter.Assemble() + WriteKernelEntry(kernel, rewriter.prologue());
}

} // namespace limn

#include "desugar/Rewrites.h"

#include "hlsl/Declarations.h"
#include <limn/base/Case.h>
#include <limn/base/Text.h>
#include <limn/base/WordList.h>

#include <algorithm>
#include <utility>

namespace limn
{

namespace
{

const WordList k_Attributes(
    "domain partitioning outputtopology patchconstantfunc outputcontrolpoints maxtessfactor");

const ProgramPragma* FindPragma(const PassProgram& program, std::string_view name)
{
    const auto found = std::ranges::find(program.pragmas, name, &ProgramPragma::name);
    return found == program.pragmas.end() ? nullptr : &*found;
}

/// Writes a vertex function that calls the author's three functions for a patch all of whose points
/// are the vertex.
class TessellationTaker
{
public:
    TessellationTaker(TokenEdits& code, const PassProgram& program)
        : m_Code(code),
          m_Declarations(ReadDeclarations(code.tokens())),
          m_Vertex(m_Declarations.FindDefinition(program.vertex.name))
    {
        std::vector<Diagnostic> missing;
        for (const auto& [pragma, found] :
             {std::pair("hull", &m_Hull), std::pair("domain", &m_Domain)})
        {
            const ProgramPragma* const named = FindPragma(program, pragma);
            const std::string_view function = named ? Trim(named->arguments) : "";
            *found = named ? m_Declarations.FindDefinition(function) : nullptr;
            // glslang tells what is wrong with a function that the text has.
            if (named && !*found && m_Vertex &&
                std::ranges::count(code.tokens().all(), function, &HlslToken::text) == 0)
            {
                missing.push_back({Severity::Error, program.file, named->location,
                                   std::string("#pragma ") + pragma + ": there is no function '" +
                                       std::string(function) + "'"});
            }
        }
        if (!missing.empty())
        {
            throw AssetError(std::move(missing));
        }
    }

    void Take()
    {
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (Text(i) == "[" && k_Attributes.Has(Text(i + 1)))
            {
                m_Code.Erase(i, m_Code.AfterBracket(i));
            }
            else if (isPatch(i))
            {
                TakePatch(i);
            }
        }
        if (m_Vertex && m_Hull && m_Domain)
        {
            Join();
        }
    }

private:
    std::string_view Text(std::size_t index) const { return m_Code.Text(index); }

    /// `InputPatch<Type, 3> name`
    bool isPatch(std::size_t index) const
    {
        return (Text(index) == "InputPatch" || Text(index) == "OutputPatch") &&
               Text(index + 1) == "<" && Text(index + 3) == "," && Text(index + 5) == ">" &&
               m_Code.isWord(index + 6);
    }

    /// It becomes an array.
    void TakePatch(std::size_t index)
    {
        m_Code.Spelling(index) = Text(index + 2);
        m_Code.Spelling(index + 6) =
            std::string(Text(index + 6)) + "[" + std::string(Text(index + 4)) + "]";
        m_Code.Erase(index + 1, index + 6);
    }

    /// Returns assignments to a variable of type `to` of the members that `from` has as well: those
    /// of the same semantic.
    std::string CopyMembers(std::string_view to, const std::string& name, std::string_view from,
                            const std::string& point) const
    {
        const auto meaning = [](const HlslVariable& member)
        {
            std::string text = ToLower(member.semantic);
            const std::size_t index = text.find_last_not_of("0123456789") + 1;
            text.erase(text.substr(index) == "0" ? index : text.size());
            return text == "sv_position" ? std::string("position") : text;
        };
        const HlslStruct* const target = m_Declarations.FindStruct(m_Declarations.ResolveAlias(to));
        const HlslStruct* const source =
            m_Declarations.FindStruct(m_Declarations.ResolveAlias(from));
        std::string copies;
        for (std::size_t i = 0; target && source && i < target->members.size(); ++i)
        {
            const HlslVariable& member = target->members[i];
            const auto other = std::ranges::find(source->members, meaning(member), meaning);
            if (other != source->members.end())
            {
                copies += name + "." + std::string(member.name) + " = " + point + "." +
                          std::string(other->name) + "; ";
            }
        }
        return copies;
    }

    /// Returns a call of a function, and adds what comes before it.
    /// @param point  the point of the patch, which is of the type `pointType`
    std::string Call(const HlslFunction& function, const std::string& point,
                     std::string_view pointType, std::string& before)
    {
        std::string call = std::string(function.name) + "(";
        for (const HlslVariable& parameter : function.parameters)
        {
            const std::string name = "limn_Argument" + std::to_string(m_Arguments++);
            const std::string type(parameter.type);
            const std::size_t patch = parameter.token - 6;
            if (isPatch(patch))
            {
                const std::string count(Text(patch + 4));
                const std::string corner(Text(patch + 2));
                std::string value = point;
                if (m_Declarations.ResolveAlias(corner) != m_Declarations.ResolveAlias(pointType))
                {
                    value = name + "_Corner";
                    before += corner + " " + value + " = (" + corner + ")0; " +
                              CopyMembers(corner, value, pointType, point);
                }
                before += corner + " " + name + "[" + count + "]; ";
                for (int i = 0; i < std::min(32, std::atoi(count.c_str())); ++i)
                {
                    before += name + "[" + std::to_string(i) + "] = " + value + "; ";
                }
            }
            else
            {
                // All points being one, it does not matter which part each has of the place.
                const bool isCorner = EqualsIgnoringCase(parameter.semantic, "SV_DomainLocation");
                before += type + " " + name + " = (" + type + ")0; ";
                before += isCorner ? name + ".x = 1; " : "";
            }
            call += (call.back() == '(' ? "" : ", ") + name;
        }
        return call + ")";
    }

    void Join()
    {
        const std::string vertex(m_Vertex->name);
        const std::string author = "limn_Point_" + vertex;
        std::string arguments;
        for (const HlslVariable& parameter : m_Vertex->parameters)
        {
            arguments += (arguments.empty() ? "" : ", ") + std::string(parameter.name);
        }
        std::string body = std::string(m_Vertex->returnType) + " limn_Vertex = " + author + "(" +
                           arguments + "); ";
        const std::string hull = Call(*m_Hull, "limn_Vertex", m_Vertex->returnType, body);
        body += std::string(m_Hull->returnType) + " limn_Point = " + hull + "; ";
        const std::string domain = Call(*m_Domain, "limn_Point", m_Hull->returnType, body);
        const std::size_t open = m_Vertex->token + 1;
        const std::string semantic =
            m_Domain->semantic.empty() ? "" : " : " + std::string(m_Domain->semantic);
        const std::string joined = " " + std::string(m_Domain->returnType) + " " + vertex +
                                   m_Code.Spelled(open, m_Code.AfterBracket(open)) + semantic +
                                   " { " + body + "return " + domain + "; }";
        m_Code.Spelling(m_Domain->token - 1)
            .insert(0, "[limn_Lacks(\"tessellation\", \"it moves the mesh's own vertices as the "
                       "domain function does, and adds none\")] ");
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (Text(i) == vertex && Text(i + 1) == "(")
            {
                m_Code.Spelling(i) = author;
            }
        }
        m_Code.Spelling(m_Code.size() - 1) += joined;
    }

    TokenEdits& m_Code;
    const HlslDeclarations m_Declarations;
    const HlslFunction* m_Vertex = nullptr;
    const HlslFunction* m_Hull = nullptr;
    const HlslFunction* m_Domain = nullptr;
    int m_Arguments = 0;
};

} // namespace

void TakeTessellation(TokenEdits& code, const PassProgram& program)
{
    if (FindPragma(program, "hull") != nullptr)
    {
        TessellationTaker(code, program).Take();
    }
}

} // namespace limn

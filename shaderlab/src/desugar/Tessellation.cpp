#include "desugar/Rewrites.h"

#include <limn/base/Case.h>
#include <limn/base/Text.h>
#include <limn/base/WordList.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
        : m_Code(code), m_Vertex(FindDefinition(program.vertex.name))
    {
        std::vector<Diagnostic> missing;
        for (const auto& [pragma, found] :
             {std::pair("hull", &m_Hull), std::pair("domain", &m_Domain)})
        {
            const ProgramPragma* const named = FindPragma(program, pragma);
            *found = named ? FindDefinition(Trim(named->arguments)) : std::nullopt;
            if (named && !*found && m_Vertex)
            {
                missing.push_back({Severity::Error, program.file, named->location,
                                   std::string("#pragma ") + pragma + ": there is no function '" +
                                       std::string(Trim(named->arguments)) + "'"});
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

    /// Returns the name's token.
    std::optional<std::size_t> FindDefinition(std::string_view name) const
    {
        for (std::size_t i = 1; i < m_Code.size(); i = m_Code.AfterBracket(i))
        {
            if (!name.empty() && Text(i) == name && m_Code.isWord(i - 1) && Text(i + 1) == "(" &&
                Text(m_Code.AfterBracket(i + 1)) != ";")
            {
                return i;
            }
        }
        return std::nullopt;
    }

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

    struct Parameter
    {
        std::size_t type = 0;
        std::size_t name = 0;
        std::size_t end = 0; ///< the `,` or `)` behind it
        std::string_view semantic;
    };

    std::vector<Parameter> ParametersOf(std::size_t function) const
    {
        std::vector<Parameter> parameters;
        const std::size_t close = m_Code.AfterBracket(function + 1) - 1;
        for (std::size_t begin = function + 2; begin < close;)
        {
            Parameter parameter;
            // The comma within `<…, 3>` parts none.
            const std::size_t from = begin + (Text(begin) == "const" ? 1 : 0);
            const std::size_t behind = isPatch(from) ? from + 6 : begin;
            parameter.end = std::min(m_Code.FindOutside(behind, ","), close);
            const std::size_t colon = std::min(m_Code.FindOutside(behind, ":"), parameter.end);
            parameter.semantic = colon < parameter.end ? Text(colon + 1) : std::string_view();
            parameter.name = colon - 1;
            parameter.type = isPatch(from) ? from : parameter.name - 1;
            parameters.push_back(parameter);
            begin = parameter.end + 1;
        }
        return parameters;
    }

    /// Returns a call of a function, and adds what comes before it.
    /// @param point  the point of the patch
    std::string Call(std::size_t function, const std::string& point, std::string& before)
    {
        std::string call = std::string(Text(function)) + "(";
        for (const Parameter& parameter : ParametersOf(function))
        {
            const std::string name = "limn_Argument" + std::to_string(m_Arguments++);
            const std::string type(Text(parameter.type));
            if (isPatch(parameter.type))
            {
                const std::string count(Text(parameter.type + 4));
                before += std::string(Text(parameter.type + 2)) + " " + name + "[" + count + "]; ";
                for (int i = 0; i < std::min(32, std::atoi(count.c_str())); ++i)
                {
                    before += name + "[" + std::to_string(i) + "] = " + point + "; ";
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
        const std::string author = "limn_Point_" + std::string(Text(*m_Vertex));
        std::string arguments;
        for (const Parameter& parameter : ParametersOf(*m_Vertex))
        {
            arguments += (arguments.empty() ? "" : ", ") + std::string(Text(parameter.name));
        }
        std::string body =
            std::string(Text(*m_Vertex - 1)) + " limn_Vertex = " + author + "(" + arguments + "); ";
        const std::string hull = Call(*m_Hull, "limn_Vertex", body);
        body += std::string(Text(*m_Hull - 1)) + " limn_Point = " + hull + "; ";
        const std::string domain = Call(*m_Domain, "limn_Point", body);
        const std::size_t open = *m_Vertex + 1;
        const std::size_t close = m_Code.AfterBracket(*m_Domain + 1);
        const std::string semantic =
            Text(close) == ":" ? " : " + std::string(Text(close + 1)) : std::string();
        const std::string joined = " " + std::string(Text(*m_Domain - 1)) + " " +
                                   std::string(Text(*m_Vertex)) +
                                   m_Code.Spelled(open, m_Code.AfterBracket(open)) + semantic +
                                   " { " + body + "return " + domain + "; }";
        m_Code.Spelling(*m_Domain - 1)
            .insert(0, "[limn_Lacks(\"tessellation\", \"it moves the mesh's own vertices as the "
                       "domain function does, and adds none\")] ");
        for (std::size_t i = 0; i < m_Code.size(); ++i)
        {
            if (Text(i) == Text(*m_Vertex) && Text(i + 1) == "(")
            {
                m_Code.Spelling(i) = author;
            }
        }
        m_Code.Spelling(m_Code.size() - 1) += joined;
    }

    TokenEdits& m_Code;
    std::optional<std::size_t> m_Vertex;
    std::optional<std::size_t> m_Hull;
    std::optional<std::size_t> m_Domain;
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

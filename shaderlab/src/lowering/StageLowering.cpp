#include "lowering/StageLowering.h"

#include <limn/shaderlab/UnsupportedProgramError.h>

#include "hlsl/DuplicateDeclarations.h"
#include "hlsl/TokenEdits.h"
#include "hlsl/TreeParser.h"
#include "lowering/GlslangGuards.h"
#include "lowering/Lowering.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <functional>
#include <set>
#include <span>

namespace limn
{

namespace
{

constexpr std::string_view k_DrawIndex = "limn_DrawIndex";

/// Returns the text between the quotes.
std::string Unquoted(std::string_view text)
{
    return std::string(text.size() > 1 ? text.substr(1, text.size() - 2) : text);
}

/// `1.5h`
bool isHalfNumber(std::string_view text)
{
    return text.size() > 1 && (isDigit(text[0]) || text[0] == '.') && ToLower(text.back()) == 'h' &&
           !text.starts_with("0x") && !text.starts_with("0X");
}

class StageLowering
{
public:
    StageLowering(const HlslSource& source, std::string_view entry)
        : m_Source(source),
          m_Tokens(source.tokens),
          m_Code(source.tokens),
          m_Lowering(m_Code, source.globals),
          m_Resolver(source.tokens, source.globals),
          m_Reach(source.tokens, source.globals, entry)
    {
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            const std::string_view text = m_Tokens.Text(i);
            if (text == k_TakenName && !m_Reach.isLeftOut()[i])
            {
                m_Code.Spelling(i) = AuthorFunctionName(k_TakenName);
            }
            else if (isHalfNumber(text))
            {
                // glslang cannot multiply it by an integer; without the letter it becomes what it
                // meets.
                m_Code.Spelling(i) = text.substr(0, text.size() - 1);
            }
        }
        ReadTrees();
    }

    const ReachableFunctions& reach() const { return m_Reach; }

    /// Refuses objects that can be written to, which limn allows in compute shaders only.
    void RefuseWritable() const
    {
        for (const HlslVariable& object : m_Source.declarations.objects)
        {
            if (isWritable(object.type) && m_Reach.Names(object.name))
            {
                throw UnsupportedProgramError(m_Tokens.Error(
                    object.token, "a " + std::string(object.type) +
                                      " can be written to, but limn allows that in compute shaders "
                                      "only; in a pass, read a texture or buffer"));
            }
        }
    }

    /// All that every stage needs.
    void Rewrite()
    {
        TakeStandIns();
        RefuseMatrices();
        for (const std::size_t token : m_Source.declarations.emptyMembers)
        {
            m_Code.Spelling(token).clear(); // macros leave them
        }
        const DuplicateDeclarations removed = RemoveDuplicates(m_Code, m_Source.declarations);
        MoveObjectsOutOfBuffers();
        ReplaceStaticObjects();
        CopyAssignedUniforms();
        FindDelayedStatics();
        Lower();
        DelayStatics();
        ClearStatics();
        MoveBuffersUp(m_Code, removed, m_Reach.isLeftOut());
    }

    RewrittenHlsl Finish(const std::string& entry)
    {
        std::map<std::size_t, std::string> unknownNames;
        for (const HlslProblem& name : m_Resolver.unknown())
        {
            unknownNames[name.token] = name.text;
        }
        return {m_Lowering.functions() + m_Code.AssembleByToken(m_Reach.isLeftOut()) + entry,
                m_StandIns, m_UnknownTypes, unknownNames, std::move(m_Nodes)};
    }

    /// glslang crashes on those of bool, and has none of one row or column.
    void RefuseMatrices() const
    {
        std::vector<HlslProblem> problems;
        for (std::size_t i = 0; i < m_Tokens.size(); ++i)
        {
            const std::string_view word = m_Tokens.Text(i);
            const bool isTemplate = word == "matrix" && m_Tokens.Text(i + 1) == "<";
            const bool isMatrix = isTemplate || (word.size() > 5 && word[word.size() - 2] == 'x');
            if (!isMatrix || m_Reach.isLeftOut()[i])
            {
                continue;
            }
            const std::string_view argument =
                isTemplate ? m_Tokens.Span(i + 2, m_Tokens.FindOutside(i, ">"))
                           : std::string_view();
            const HlslType type = TypeOf(m_Source.declarations, word, argument);
            const bool isFlat = type.isMatrix() && (type.rows == 1 || type.columns == 1);
            if (type.isMatrix() && (isFlat || type.scalar == HlslScalar::Bool))
            {
                const std::string other = isFlat ? type.As(type.components()).Spelling()
                                                 : type.Of(HlslScalar::Float).Spelling();
                problems.push_back({i, std::string("limn has no matrices of ") +
                                           (isFlat ? "one row or column" : "bool") + "; use '" +
                                           other + "'"});
            }
        }
        m_Tokens.Refuse(problems);
    }

    /// Everything that glslang takes for something else.
    void Lower()
    {
        m_Lowering.Rename(m_Resolver, m_Nodes);
        for (const Tree& tree : m_Trees)
        {
            m_Lowering.Lower(*tree.root, tree.variable && !m_Delayed.contains(tree.variable));
            if (tree.variable)
            {
                m_Lowering.LowerInitializer(*tree.root,
                                            TypeOf(m_Source.declarations, *tree.variable),
                                            tree.variable->dimensions);
            }
        }
        for (const HlslFunction& function : m_Source.declarations.functions)
        {
            if (const std::string* spelling = m_Source.globals.FindSpelling(function))
            {
                m_Code.Spelling(function.token) = *spelling;
            }
        }
    }

    /// Replaces static textures, samplers and buffers, and elements of arrays of them, by what
    /// their values name. To SPIR-V they are no variables, and D3D's compiler replaces them as
    /// well.
    void ReplaceStaticObjects()
    {
        std::vector<HlslProblem> problems;
        const auto first =
            std::stable_partition(m_Trees.begin(), m_Trees.end(), std::not_fn(isStaticObject));
        const std::span<const Tree> objects(first, m_Trees.end());
        for (const Tree& tree : objects)
        {
            ReplaceUses(*tree.root, *tree.variable, problems);
        }
        for (const Tree& tree : objects) // several may have one declaration
        {
            m_Code.Erase(tree.variable->firstToken, tree.variable->semicolon + 1);
        }
        m_Tokens.Refuse(problems);
        m_Trees.erase(first, m_Trees.end());
    }

    /// Gives each uniform that the code assigns to a writable copy.
    void CopyAssignedUniforms()
    {
        for (const HlslVariable* uniform : FindWrittenUniforms(m_Nodes, m_Tokens, m_Source.globals))
        {
            Copy(*uniform);
        }
    }

    /// Finds static variables that begin with the result of a function. The entry function sets
    /// them, because to glslang such a function calls itself. The same holds for values for which
    /// limn needs a function.
    void FindDelayedStatics()
    {
        for (const Tree& tree : m_Trees)
        {
            const bool isList = tree.root->kind == HlslNodeKind::List;
            const bool hasOpenSize =
                isList && tree.variable && std::ranges::count(tree.variable->dimensions, "") > 0;
            if (tree.variable && !hasOpenSize &&
                (CallsOrNames(*tree.root, m_Delayed) || m_Lowering.NeedsFunction(*tree.root)))
            {
                m_Delayed.insert(tree.variable);
            }
        }
    }

    /// @pre Lower(): the values move as they are spelled by then.
    void DelayStatics()
    {
        for (const Tree& tree : m_Trees)
        {
            if (!m_Delayed.contains(tree.variable))
            {
                continue;
            }
            const HlslVariable& variable = *tree.variable;
            const std::string value = m_Code.Spelled(tree.root->first, tree.root->end);
            const std::string name(variable.name);
            m_Prologue += tree.root->kind == HlslNodeKind::List
                              ? "{ " + DeclarationOf("limn_value", variable) + " = " + value +
                                    "; " + name + " = limn_value; }\n"
                              : name + " = " + value + ";\n";
            m_Code.Erase(tree.root->first - 1, tree.root->end);
            for (std::size_t i = variable.firstToken; i < variable.token; ++i)
            {
                if (m_Tokens.Text(i) == "const")
                {
                    m_Code.Spelling(i).clear();
                }
            }
        }
    }

    /// Statics begin with zeros in HLSL; glslang leaves their values undefined.
    void ClearStatics()
    {
        for (const HlslVariable& variable : m_Source.declarations.statics)
        {
            const HlslType type = TypeOf(m_Source.declarations, variable);
            const bool isStruct = type.kind == HlslType::Kind::Struct;
            if (variable.Has("static") && variable.valueToken == 0 && type.dimensions == 0 &&
                (type.isNumber() || isStruct))
            {
                m_Code.Spelling(variable.token) +=
                    " = (" + (isStruct ? std::string(type.name) : type.Spelling()) + ")" +
                    (type.isMatrix() ? "0.0" : "0");
            }
        }
    }

    /// Textures and the like are no members of a buffer to glslang, though HLSL lets them stand
    /// there.
    void MoveObjectsOutOfBuffers()
    {
        std::size_t last = 0; // declaration: several names may have one
        for (const HlslVariable& object : m_Source.declarations.objects)
        {
            if (!object.isInBuffer || object.semicolon == 0 || object.semicolon == last)
            {
                continue;
            }
            last = object.semicolon;
            const std::string moved = " " + m_Code.Spelled(object.firstToken, object.semicolon + 1);
            m_Code.Erase(object.firstToken, object.semicolon + 1);
            const std::size_t end = object.endToken;
            m_Code.Insert(m_Tokens.Text(end + 1) == ";" ? end + 1 : end, moved);
        }
    }

    /// Makes an ordinary function of the author's geometry function; see EntryPointWriter.h.
    void TakeGeometryApart(const StageInterface& interface, const StageLinkage& linkage)
    {
        std::size_t first = interface.function->begin;
        for (const HlslFunction* function : m_Reach.functions())
        {
            for (std::size_t i = function->begin; i < function->end; ++i)
            {
                const std::string_view text = m_Tokens.Text(i);
                const bool isAppend = text == "Append" && m_Tokens.Text(i - 1) == ".";
                if (isAppend)
                {
                    m_Code.Spelling(i + 1) += std::string(k_PackFunction) + "(";
                    m_Code.Spelling(m_Tokens.AfterBracket(i + 1) - 1) += ")";
                }
                else if (isStream(text) && m_Tokens.Text(i + 1) == "<")
                {
                    m_Code.Spelling(i + 2) = k_GeometryOutput;
                }
                else if (text == interface.geometry->primitive)
                {
                    m_Code.Spelling(i).clear();
                }
                first = isAppend || isStream(text) ? std::min(first, function->begin) : first;
            }
        }
        if (first > 0)
        {
            m_Code.Insert(first - 1, " " + WriteGeometryTypes(interface, linkage));
        }
    }

    /// Takes the marks off, which are no HLSL, and tells what those of reached functions say.
    void TakeStandIns()
    {
        for (const HlslFunction* function : m_Reach.functions())
        {
            for (std::size_t i = function->begin; m_Tokens.Text(i) == "[";)
            {
                const std::size_t end = m_Tokens.AfterBracket(i);
                if (m_Tokens.Text(i + 1) == "limn_Lacks") // ("X", "Y")
                {
                    m_StandIns.push_back(
                        "it uses " + Unquoted(m_Tokens.Text(i + 3)) +
                        ", which limn does not have: " + Unquoted(m_Tokens.Text(i + 5)));
                    m_Code.Erase(i, end);
                }
                i = end;
            }
        }
    }

    /// Moves the attributes of an entry function to the generated one.
    void TakeAttributes(const HlslFunction& function)
    {
        for (std::size_t i = function.begin, end = i; m_Tokens.Text(i) == "["; i = end)
        {
            end = m_Tokens.AfterBracket(i);
            m_Code.Erase(i, end);
        }
    }

    const std::string& prologue() const { return m_Prologue; }

private:
    /// A function's body or a static variable's value.
    struct Tree
    {
        HlslNode* root = nullptr;
        const HlslVariable* variable = nullptr; ///< null of a body
    };

    static bool isStaticObject(const Tree& tree)
    {
        return tree.variable && isObjectType(tree.variable->type) && tree.variable->semicolon > 0;
    }

    void ReplaceUses(const HlslNode& value, const HlslVariable& object,
                     std::vector<HlslProblem>& problems)
    {
        for (const HlslNode& node : m_Nodes)
        {
            if (node.kind != HlslNodeKind::Name || node.local || node.variable != &object)
            {
                continue;
            }
            const bool isElement = node.parent && node.parent->kind == HlslNodeKind::Index &&
                                   node.parent->child == &node;
            const bool isArray = value.kind == HlslNodeKind::List;
            const HlslNode& use = isElement ? *node.parent : node;
            const HlslNode* replacement = !isArray    ? &value
                                          : isElement ? FindElement(value, *node.next)
                                                      : nullptr;
            if (!replacement)
            {
                problems.push_back(
                    {use.first, "'" + std::string(m_Tokens.Span(use.first, use.end)) +
                                    "': the index of an array of static textures must be a "
                                    "constant whole number, here less than " +
                                    std::to_string(value.CountChildren()) +
                                    "; choose with 'if' or 'switch' between the textures"});
                continue;
            }
            const std::string text = m_Code.Spelled(replacement->first, replacement->end);
            m_Code.Erase(use.first, use.end);
            m_Code.Spelling(use.first) = text;
        }
    }

    /// Returns the element of the list at a constant index, or null if there is none.
    const HlslNode* FindElement(const HlslNode& list, const HlslNode& index) const
    {
        const IntegerNames& constants = m_Source.declarations.constants;
        const auto varies = [&](const HlslNode& node)
        {
            switch (node.kind)
            {
            case HlslNodeKind::Literal:
                return node.type.scalar != HlslScalar::Int && node.type.scalar != HlslScalar::Uint;
            case HlslNodeKind::Name:
                return node.local || !constants.contains(m_Tokens.Text(node.token));
            case HlslNodeKind::Paren:
            case HlslNodeKind::Prefix:
            case HlslNodeKind::Binary:
                return false;
            default:
                return true;
            }
        };
        const std::int64_t at =
            FindNode(index, varies)
                ? -1
                : EvaluateInteger(m_Tokens.Span(index.first, index.end), constants);
        return at < 0 ? nullptr : list.Child(static_cast<std::size_t>(at));
    }

    static bool isWritable(std::string_view type)
    {
        return type.starts_with("RW") || type.starts_with("RasterizerOrdered") ||
               type == "AppendStructuredBuffer" || type == "ConsumeStructuredBuffer";
    }

    void ReadTrees()
    {
        HlslTreeParser parser(m_Tokens, m_Source.declarations, m_Nodes);
        const auto add = [&](const HlslFunction& function, const HlslStruct* owner)
        {
            if (function.hasBody)
            {
                m_Trees.push_back({parser.ParseBlock(function.body), nullptr});
                m_Resolver.ResolveBody(*m_Trees.back().root, function, owner);
            }
        };
        for (const HlslVariable& variable : m_Source.declarations.statics)
        {
            if (variable.valueToken > 0)
            {
                m_Trees.push_back(
                    {parser.ParseValue(variable.valueToken, variable.valueEnd), &variable});
                m_Resolver.Resolve(*m_Trees.back().root);
            }
        }
        for (const HlslFunction& function : m_Source.declarations.functions)
        {
            if (m_Reach.functions().contains(&function))
            {
                add(function, nullptr);
            }
        }
        for (const HlslStruct& owner : m_Source.declarations.structs)
        {
            for (const HlslFunction& method : owner.methods)
            {
                add(method, &owner);
            }
        }
        m_Tokens.Refuse(parser.unended());
        RequireSoundNodes(m_Nodes, m_Tokens, m_Source.globals);
        m_UnknownTypes = parser.unknownTypes();
    }

    /// Returns whether the value calls a function of the author or names one of the variables.
    bool CallsOrNames(const HlslNode& value, const std::set<const HlslVariable*>& variables) const
    {
        const auto isOne = [&](const HlslNode& node)
        {
            return node.kind == HlslNodeKind::Call
                       ? !m_Source.globals.FindFunctions(m_Tokens.Text(node.token)).empty()
                       : node.kind == HlslNodeKind::Name && variables.contains(node.variable);
        };
        return FindNode(value, isOne) != nullptr;
    }

    void Copy(const HlslVariable& uniform)
    {
        const std::string copy = "limn_copy" + std::string(uniform.name);
        m_Code.Insert(uniform.endToken, " static " + DeclarationOf(copy, uniform) + ";");
        m_Prologue += copy + " = " + std::string(uniform.name) + ";\n";
        for (const HlslNode& node : m_Nodes)
        {
            if (node.kind == HlslNodeKind::Name && !node.local && node.variable == &uniform)
            {
                m_Code.Spelling(node.token) = copy;
            }
        }
    }

    const HlslSource& m_Source;
    const HlslTokens& m_Tokens;
    TokenEdits m_Code;
    HlslLowering m_Lowering;
    HlslResolver m_Resolver;
    const ReachableFunctions m_Reach;
    HlslNodes m_Nodes;
    std::vector<Tree> m_Trees;
    std::vector<std::size_t> m_UnknownTypes;
    std::set<const HlslVariable*> m_Delayed; ///< statics that the entry function sets
    std::string m_Prologue;
    std::vector<std::string> m_StandIns;
};

} // namespace

HlslSource::HlslSource(std::string preprocessed, ColumnFinder* lines)
    : text(std::move(preprocessed)),
      tokens(text, lines),
      declarations(ReadDeclarations(tokens)),
      globals(declarations)
{
}

RewrittenHlsl RewriteStage(const HlslSource& source, ShaderStage stage,
                           const StageInterface& interface, const StageLinkage& linkage)
{
    StageLowering lowering(source, interface.function->name);
    lowering.RefuseWritable();
    lowering.Rewrite();
    if (interface.geometry)
    {
        lowering.TakeGeometryApart(interface, linkage);
    }
    return lowering.Finish(WriteEntryPoint(interface, linkage, stage, lowering.prologue(),
                                           lowering.reach().Names(k_DrawIndex)));
}

RewrittenHlsl RewriteKernel(const HlslSource& source, const HlslFunction& kernel)
{
    const auto fail = [&](const std::string& message)
    {
        throw AssetError({source.tokens.Error(kernel.token, message)});
    };
    if (ThreadsOf(kernel).empty())
    {
        fail("a kernel must set the number of threads of a group; write '[numthreads(8, 8, 1)]' "
             "before it");
    }
    if (!HasValidThreads(ThreadsOf(kernel), source.declarations.constants))
    {
        fail("a group cannot have " + std::string(ThreadsOf(kernel)) +
             "; write three constants, 1 to 1024 along x and y and 1 to 64 along z, which make at "
             "most 1024 threads");
    }
    StageLowering lowering(source, kernel.name);
    if (lowering.reach().Names(k_DrawIndex))
    {
        fail("it reads a value that belongs to a draw, such as unity_ObjectToWorld; a kernel draws "
             "nothing, so pass the value as a parameter");
    }
    lowering.Rewrite();
    lowering.TakeAttributes(kernel);
    return lowering.Finish(WriteKernelEntry(kernel, lowering.prologue()));
}

} // namespace limn

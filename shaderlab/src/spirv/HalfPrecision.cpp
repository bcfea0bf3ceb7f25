#include "spirv/HalfPrecision.h"

#include <glslang/SPIRV/GLSL.std.450.h>
#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace limn
{

namespace
{

/// Returns whether an instruction that gives floats is done on 16-bit floats.
bool HasHalfForm(const SpirvInstruction& instruction)
{
    constexpr std::array k_Operations = {spv::OpFNegate, spv::OpFAdd, spv::OpFSub,
                                         spv::OpFMul,    spv::OpFDiv, spv::OpFRem,
                                         spv::OpFMod,    spv::OpDot,  spv::OpVectorTimesScalar};
    // Pointers and integers stand beside the floats.
    constexpr std::array k_Without = {GLSLstd450Modf, GLSLstd450Frexp, GLSLstd450Ldexp,
                                      GLSLstd450InterpolateAtOffset};
    return instruction.op == spv::OpExtInst
               ? std::ranges::find(k_Without, static_cast<GLSLstd450>(instruction.words[4])) ==
                     k_Without.end()
               : std::ranges::find(k_Operations, static_cast<spv::Op>(instruction.op)) !=
                     k_Operations.end();
}

/// Returns whether an operation that gives floats only moves components.
bool IsMove(std::uint32_t op)
{
    return op == spv::OpCompositeConstruct || op == spv::OpCompositeExtract ||
           op == spv::OpCompositeInsert || op == spv::OpVectorShuffle ||
           op == spv::OpVectorExtractDynamic || op == spv::OpVectorInsertDynamic ||
           op == spv::OpSelect || op == spv::OpCopyObject;
}

class HalfRewriter
{
public:
    explicit HalfRewriter(const SpirvWords& spirv)
        : m_Instructions(ParseSpirv(spirv)),
          m_Bound(spirv[k_SpirvBoundWord]),
          m_Result(spirv.begin(), spirv.begin() + k_SpirvHeaderSize)
    {
        std::ranges::for_each(m_Instructions, [this](const auto& i) { Learn(i); });
    }

    bool isNeeded() const { return !m_Relaxed.empty() || !m_RelaxedMembers.empty(); }

    SpirvWords Rewrite()
    {
        const auto body = std::ranges::find(m_Instructions, std::uint32_t{spv::OpFunction},
                                            &SpirvInstruction::op);
        for (auto& type : m_HalfTypes)
        {
            type = m_Bound++;
        }
        for (auto instruction = body; instruction != m_Instructions.end(); ++instruction)
        {
            RewriteInBody(*instruction);
        }
        Assemble(static_cast<std::size_t>(body - m_Instructions.begin()));
        m_Result[k_SpirvBoundWord] = m_Bound;
        return std::move(m_Result);
    }

private:
    /// Types, and what is marked.
    void Learn(const SpirvInstruction& i)
    {
        const SpirvWords& w = i.words;
        m_TypeOf[i.result] = i.type;
        if (i.op == spv::OpTypeFloat && w[2] == 32)
        {
            m_Components[i.result] = 1;
        }
        else if (i.op == spv::OpTypeVector && m_Components.contains(w[2]))
        {
            m_Components[i.result] = w[3];
        }
        else if (i.op == spv::OpTypePointer)
        {
            m_Pointee[i.result] = w[3];
        }
        else if (i.op == spv::OpTypeStruct)
        {
            m_Members[i.result].assign(w.begin() + 2, w.end());
        }
        else if (i.op == spv::OpTypeArray || i.op == spv::OpTypeRuntimeArray)
        {
            m_Element[i.result] = w[2];
        }
        else if (i.op == spv::OpConstant && w.size() == 4)
        {
            m_Numbers[i.result] = w[3];
        }
        else if (i.op == spv::OpFunction)
        {
            m_Parameters[i.result];
            m_Function = i.result;
        }
        else if (i.op == spv::OpFunctionParameter)
        {
            m_Parameters[m_Function].push_back(i.result);
        }
        else if (IsRelaxation(i) && i.op == spv::OpDecorate)
        {
            m_Relaxed.insert(w[1]);
        }
        else if (IsRelaxation(i))
        {
            m_RelaxedMembers.insert({w[1], w[2]});
        }
        if (i.op == spv::OpUndef || (i.op >= spv::OpConstantTrue && i.op <= spv::OpSpecConstantOp))
        {
            m_Constants.insert(i.result);
        }
    }

    static bool IsRelaxation(const SpirvInstruction& i)
    {
        return (i.op == spv::OpDecorate && i.words[2] == spv::DecorationRelaxedPrecision) ||
               (i.op == spv::OpMemberDecorate && i.words[3] == spv::DecorationRelaxedPrecision);
    }

    /// A number or a vector of 32-bit floats: how many components, or else 0.
    std::uint32_t ComponentsOf(Id value) const
    {
        const auto type = m_TypeOf.find(value);
        const auto found =
            type != m_TypeOf.end() ? m_Components.find(type->second) : m_Components.end();
        return found != m_Components.end() ? found->second : 0;
    }

    /// Returns whether the way from a type through these words, literals or constants, leads
    /// through a marked member.
    bool LeadsThroughMarked(Id type, const SpirvInstruction& i, std::size_t from,
                            bool isLiteral) const
    {
        for (std::size_t word = from; word < i.words.size(); ++word)
        {
            if (const auto members = m_Members.find(type); members != m_Members.end())
            {
                const std::uint32_t index = isLiteral ? i.words[word] : m_Numbers.at(i.words[word]);
                if (m_RelaxedMembers.contains({type, index}))
                {
                    return true;
                }
                type = members->second[index];
            }
            else if (const auto element = m_Element.find(type); element != m_Element.end())
            {
                type = element->second;
            }
        }
        return false;
    }

    void RewriteInBody(SpirvInstruction& i)
    {
        switch (i.op)
        {
        case spv::OpFunction:
            m_Function = i.result;
            break;
        case spv::OpVariable:
        case spv::OpFunctionParameter:
            MarkPlace(i, m_Relaxed.contains(i.result));
            break;
        case spv::OpAccessChain:
        case spv::OpInBoundsAccessChain:
            MarkPlace(i,
                      IsHalfPlace(i.words[3]) ||
                          LeadsThroughMarked(m_Pointee.at(m_TypeOf.at(i.words[3])), i, 4, false));
            break;
        case spv::OpStore:
            i.words[2] = IsHalfPlace(i.words[1]) ? Rounded(i.words[2]) : i.words[2];
            break;
        case spv::OpReturnValue:
            i.words[1] = m_Relaxed.contains(m_Function) ? Rounded(i.words[1]) : i.words[1];
            break;
        case spv::OpFunctionCall:
            RoundArguments(i);
            break;
        default:
            if (i.op >= spv::OpFOrdEqual && i.op <= spv::OpFUnordGreaterThanEqual) // compares
            {
                RoundConstants(i);
            }
            break;
        }
        if (i.result == 0 || ComponentsOf(i.result) == 0)
        {
            Put(i);
        }
        else if (AreHalves(i) && HasHalfForm(i))
        {
            PutInHalf(i);
        }
        else
        {
            PutFloat(i);
        }
    }

    /// An instruction whose result is 32-bit floats.
    void PutFloat(SpirvInstruction& i)
    {
        const bool isHalfMove = IsMove(i.op) && AreHalves(i);
        if (isHalfMove)
        {
            RoundConstants(i);
        }
        const bool isHalf =
            isHalfMove || (i.op == spv::OpFunctionCall && m_Relaxed.contains(i.words[3]));
        const bool isRead = i.op == spv::OpLoad && IsHalfPlace(i.words[3]);
        const bool isMember = i.op == spv::OpCompositeExtract &&
                              LeadsThroughMarked(m_TypeOf.at(i.words[3]), i, 4, true);
        if (isRead || isMember)
        {
            const Id whole = m_Bound++;
            m_TypeOf[whole] = i.type;
            const Id result = std::exchange(i.words[2], whole);
            Put(i);
            PutRounding(i.type, result, whole);
            return;
        }
        Put(i);
        if (isHalf)
        {
            m_Halves.insert(i.result);
        }
    }

    void PutInHalf(SpirvInstruction& i)
    {
        for (const std::size_t word : i.operands)
        {
            i.words[word] = ComponentsOf(i.words[word]) > 0 ? AsHalf(i.words[word]) : i.words[word];
        }
        const Id half = m_Bound++;
        i.words[1] = m_HalfTypes[ComponentsOf(i.result) - 1];
        i.words[2] = half;
        Put(i);
        m_Exact.push_back(half);
        PutConversion(i.type, i.result, half);
        m_HalfOf[i.result] = half;
        m_Halves.insert(i.result);
    }

    void MarkPlace(const SpirvInstruction& i, bool isRelaxed)
    {
        if (isRelaxed)
        {
            const bool isPlace = m_Pointee.contains(i.type); // no parameter by value
            (isPlace ? m_HalfPlaces : m_Halves).insert(i.result);
        }
    }

    bool IsHalfPlace(Id pointer) const
    {
        return m_HalfPlaces.contains(pointer) || m_Relaxed.contains(pointer);
    }

    /// Returns whether all floats among the operands are halves or constants, and not all
    /// constants.
    bool AreHalves(const SpirvInstruction& i) const
    {
        bool hasHalf = false;
        for (const std::size_t word : i.operands)
        {
            const Id operand = i.words[word];
            const bool isHalf = m_Halves.contains(operand);
            if (ComponentsOf(operand) > 0 && !isHalf && !m_Constants.contains(operand))
            {
                return false;
            }
            hasHalf = hasHalf || isHalf;
        }
        return hasHalf;
    }

    void RoundConstants(SpirvInstruction& i)
    {
        const bool hasHalf = AreHalves(i);
        for (const std::size_t word : i.operands)
        {
            if (hasHalf && m_Constants.contains(i.words[word]))
            {
                i.words[word] = Rounded(i.words[word]);
            }
        }
    }

    void RoundArguments(SpirvInstruction& i)
    {
        const std::vector<Id>& parameters = m_Parameters.at(i.words[3]);
        for (std::size_t p = 0; p < parameters.size(); ++p)
        {
            if (m_Relaxed.contains(parameters[p]))
            {
                i.words[4 + p] = Rounded(i.words[4 + p]);
            }
        }
    }

    /// The value as 16-bit floats.
    Id AsHalf(Id value)
    {
        if (const auto known = m_HalfOf.find(value); known != m_HalfOf.end())
        {
            return known->second;
        }
        const Id half = m_Bound++;
        PutConversion(m_HalfTypes[ComponentsOf(value) - 1], half, Rounded(value));
        return half;
    }

    /// The value as 32-bit floats that 16 bits can hold; what is none of floats stays as it is.
    Id Rounded(Id value)
    {
        if (ComponentsOf(value) == 0 || m_Halves.contains(value))
        {
            return value;
        }
        const Id rounded = m_Bound++;
        PutRounding(m_TypeOf.at(value), rounded, value);
        return rounded;
    }

    /// Rounds 32-bit floats to what 16 bits can hold. NVIDIA's driver takes a conversion to 16 bits
    /// and back for nothing, and leaves the value as it was; this instruction it does not.
    void PutRounding(Id type, Id rounded, Id value)
    {
        m_TypeOf[rounded] = type;
        m_Body.insert(m_Body.end(), {4u << 16 | spv::OpQuantizeToF16, type, rounded, value});
        m_Halves.insert(rounded);
        const Id half = m_Bound++; // here, so that it may be used wherever the value may
        PutConversion(m_HalfTypes[ComponentsOf(rounded) - 1], half, rounded);
        m_HalfOf[rounded] = half;
    }

    void PutConversion(Id type, Id result, Id value)
    {
        m_Body.insert(m_Body.end(), {4u << 16 | spv::OpFConvert, type, result, value});
    }

    void Put(const SpirvInstruction& i)
    {
        m_Body.insert(m_Body.end(), i.words.begin(), i.words.end());
    }

    /// Everything in its order: capabilities, decorations, types, functions.
    void Assemble(std::size_t bodyBegin)
    {
        const auto put = [this](std::initializer_list<std::uint32_t> words)
        {
            m_Result.insert(m_Result.end(), words);
        };
        put({2u << 16 | spv::OpCapability, spv::CapabilityFloat16});
        bool hasDecorations = false;
        for (std::size_t index = 0; index < bodyBegin; ++index)
        {
            const SpirvInstruction& i = m_Instructions[index];
            const bool isDecoration = i.op == spv::OpDecorate || i.op == spv::OpMemberDecorate;
            if (isDecoration && !std::exchange(hasDecorations, true))
            {
                // Another order of the operations would round otherwise.
                for (const Id id : m_Exact)
                {
                    put({3u << 16 | spv::OpDecorate, id, spv::DecorationNoContraction});
                }
            }
            if (!IsRelaxation(i))
            {
                m_Result.insert(m_Result.end(), i.words.begin(), i.words.end());
            }
        }
        put({3u << 16 | spv::OpTypeFloat, m_HalfTypes[0], 16});
        for (std::uint32_t count = 2; count <= 4; ++count)
        {
            put({4u << 16 | spv::OpTypeVector, m_HalfTypes[count - 1], m_HalfTypes[0], count});
        }
        m_Result.insert(m_Result.end(), m_Body.begin(), m_Body.end());
    }

    std::vector<SpirvInstruction> m_Instructions;
    Id m_Bound;
    std::map<Id, Id> m_TypeOf;                  ///< of values
    std::map<Id, std::uint32_t> m_Components;   ///< of types of 32-bit floats
    std::array<Id, 4> m_HalfTypes{};            ///< by components
    std::map<Id, Id> m_Pointee;                 ///< of pointer types
    std::map<Id, std::vector<Id>> m_Members;    ///< of struct types
    std::map<Id, Id> m_Element;                 ///< of array types
    std::map<Id, std::uint32_t> m_Numbers;      ///< of integer constants
    std::map<Id, std::vector<Id>> m_Parameters; ///< of functions
    std::set<Id> m_Constants;
    std::set<Id> m_Relaxed; ///< what glslang marks, results apart too
    std::set<std::pair<Id, std::uint32_t>> m_RelaxedMembers; ///< of struct types
    std::set<Id> m_HalfPlaces; ///< pointers to floats that hold 16-bit ones
    std::set<Id> m_Halves;     ///< values of 32 bits that 16 can hold
    std::map<Id, Id> m_HalfOf; ///< such a value → the 16-bit one it was made of
    std::vector<Id> m_Exact;   ///< operations on halves
    Id m_Function = 0;
    SpirvWords m_Body;
    SpirvWords m_Result;
};

} // namespace

void UseHalfPrecision(SpirvWords& spirv)
{
    if (HalfRewriter rewriter(spirv); rewriter.isNeeded())
    {
        spirv = rewriter.Rewrite();
    }
}

} // namespace limn

#include "programs/PointSize.h"

#include <bit>
#include <utility>

namespace limn::vulkan
{

namespace
{

// This number is from the SPIR-V specification.
constexpr std::uint32_t k_Output = 3; // a storage class

using Instruction = std::span<const std::uint32_t>;

class SizeWriter
{
public:
    SizeWriter(const Words& spirv, std::uint32_t floatType)
        : m_Spirv(spirv), m_Result(spirv.begin(), spirv.begin() + k_HeaderSize), m_Float(floatType)
    {
        m_Pointer = m_Result[k_BoundWord];
        m_One = m_Pointer + 1;
        m_Variable = m_Pointer + 2;
        m_Result[k_BoundWord] += 3;
    }

    Words Write()
    {
        EachInstruction(m_Spirv, [this](std::uint32_t op, Instruction words) { Copy(op, words); });
        return std::move(m_Result);
    }

private:
    void Copy(std::uint32_t op, Instruction words)
    {
        if (op >= OpTypeVoid && op <= OpTypeForwardPointer && !m_IsDecorated)
        {
            m_IsDecorated = true; // annotations come before all types
            Add(OpDecorate, {m_Variable, k_BuiltIn, BuiltInPointSize});
        }
        if (op == OpFunction)
        {
            Declare();
            m_IsEntry = words[2] == m_Entry;
        }
        const bool isAtTop = op == OpVariable || op == OpLine || op == OpNoLine;
        if (m_IsInFirstBlock && !isAtTop)
        {
            m_IsInFirstBlock = false;
            Add(OpStore, {m_Variable, m_One});
        }
        m_Result.insert(m_Result.end(), words.begin(), words.end());
        if (op == OpEntryPoint)
        {
            m_Entry = words[2];
            m_Result[m_Result.size() - words.size()] += 1u << 16; // a word longer
            m_Result.push_back(m_Variable);
        }
        if (op == OpLabel && m_IsEntry)
        {
            m_IsEntry = false;
            m_IsInFirstBlock = true;
        }
    }

    /// Before the first function.
    void Declare()
    {
        if (!std::exchange(m_IsDeclared, true))
        {
            Add(OpTypePointer, {m_Pointer, k_Output, m_Float});
            Add(OpConstant, {m_Float, m_One, std::bit_cast<std::uint32_t>(1.0f)});
            Add(OpVariable, {m_Pointer, m_Variable, k_Output});
        }
    }

    void Add(std::uint32_t op, std::initializer_list<std::uint32_t> operands)
    {
        m_Result.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | op);
        m_Result.insert(m_Result.end(), operands);
    }

    const Words& m_Spirv;
    Words m_Result;
    std::uint32_t m_Float;
    std::uint32_t m_Pointer;
    std::uint32_t m_One;
    std::uint32_t m_Variable;
    std::uint32_t m_Entry = 0;
    bool m_IsDecorated = false;
    bool m_IsDeclared = false;
    bool m_IsEntry = false;        ///< in the entry function, before its first block
    bool m_IsInFirstBlock = false; ///< of it, where only variables were so far
};

} // namespace

Words WithPointSize(const Words& vertexSpirv)
{
    std::uint32_t floatType = 0;
    EachInstruction(vertexSpirv,
                    [&](std::uint32_t op, Instruction words)
                    {
                        const bool isFloat = op == OpTypeFloat && words[2] == 32;
                        floatType = isFloat ? words[1] : floatType;
                    });
    // A position is made of floats, so that there is the type.
    const bool isComplete = HasBuiltIn(vertexSpirv, BuiltInPointSize) || floatType == 0;
    return isComplete ? vertexSpirv : SizeWriter(vertexSpirv, floatType).Write();
}

} // namespace limn::vulkan

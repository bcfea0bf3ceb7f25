#include "spirv/Arithmetic.h"

#include <glslang/SPIRV/GLSL.std.450.h>
#include <glslang/SPIRV/spirv.hpp>

#include <algorithm>
#include <bit>
#include <initializer_list>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

constexpr std::size_t k_ExtendedNumber = 4; // word of OpExtInst
constexpr std::uint32_t k_CountMask = 31;   // of shifts
constexpr std::uint32_t k_MinusOne = 0xffffffffu;
constexpr float k_IntEnd = 2147483648.0f; // one above the largest int
constexpr float k_LargestInt = 2147483520.0f;
constexpr float k_UintEnd = 4294967296.0f;
constexpr float k_LargestUint = 4294967040.0f;

/// The functions of GLSL that glslang takes, and those that do what HLSL says.
const std::map<std::uint32_t, std::uint32_t> k_RightFunctions = {
    {GLSLstd450Round, GLSLstd450RoundEven},
    {GLSLstd450FMin, GLSLstd450NMin},
    {GLSLstd450FMax, GLSLstd450NMax},
    {GLSLstd450FClamp, GLSLstd450NClamp}};

class ArithmeticRewriter
{
public:
    explicit ArithmeticRewriter(const SpirvWords& spirv)
        : m_Instructions(ParseSpirv(spirv)),
          m_Result(spirv.begin(), spirv.begin() + k_SpirvHeaderSize),
          m_Bound(spirv[k_SpirvBoundWord])
    {
    }

    SpirvWords Rewrite()
    {
        const auto body = std::ranges::find(m_Instructions, std::uint32_t{spv::OpFunction},
                                            &SpirvInstruction::op);
        for (auto i = m_Instructions.begin(); i != body; ++i)
        {
            Learn(*i);
            m_Result.insert(m_Result.end(), i->words.begin(), i->words.end());
        }
        for (auto i = body; i != m_Instructions.end(); ++i)
        {
            m_TypeOf[i->result] = i->type;
            RewriteInBody(*i);
        }
        m_Result.insert(m_Result.end(), m_Declarations.begin(), m_Declarations.end());
        m_Result.insert(m_Result.end(), m_Body.begin(), m_Body.end());
        m_Result[k_SpirvBoundWord] = m_Bound;
        return std::move(m_Result);
    }

private:
    void Learn(const SpirvInstruction& i)
    {
        const SpirvWords& w = i.words;
        m_TypeOf[i.result] = i.type;
        switch (i.op)
        {
        case spv::OpExtInstImport:
            m_Functions = i.result; // glslang always imports GLSL.std.450, and no other
            break;
        case spv::OpTypeBool:
            m_Bools[1] = i.result;
            break;
        case spv::OpTypeInt:
        case spv::OpTypeFloat:
            m_Types[i.result] = i;
            break;
        case spv::OpTypeVector:
            m_Types[i.result] = i;
            if (w[2] == m_Bools[1])
            {
                m_Bools[w[3]] = i.result;
            }
            break;
        case spv::OpConstant:
            m_Constants[i.result] = {w.begin() + 3, w.begin() + 4};
            break;
        case spv::OpConstantComposite:
            LearnComposite(i);
            break;
        default:
            break;
        }
    }

    /// Learns the numbers of a constant vector, if all of them are known.
    void LearnComposite(const SpirvInstruction& i)
    {
        SpirvWords numbers;
        for (const Id part : std::span(i.words).subspan(3))
        {
            const auto known = m_Constants.find(part);
            if (known == m_Constants.end() || known->second.size() != 1)
            {
                return;
            }
            numbers.push_back(known->second.front());
        }
        m_Constants[i.result] = std::move(numbers);
    }

    template <typename F>
    bool IsConstantOf(Id value, F&& holds) const
    {
        const auto known = m_Constants.find(value);
        return known != m_Constants.end() && std::ranges::all_of(known->second, holds);
    }

    void RewriteInBody(SpirvInstruction& i)
    {
        switch (i.op)
        {
        case spv::OpCompositeConstruct: // of one number, where a vector is asked for
            LearnComposite(i);
            break;
        case spv::OpFMod:
            PutRemainder(i);
            return;
        case spv::OpSMod:
            PutSignedRemainder(i);
            return;
        case spv::OpSDiv:
            if (!IsNeverMinusOne(i.words[4]))
            {
                PutSignedDivision(i);
                return;
            }
            break;
        case spv::OpExtInst:
            if (i.words[k_ExtendedNumber] == GLSLstd450Step)
            {
                PutStep(i);
                return;
            }
            if (const auto right = k_RightFunctions.find(i.words[k_ExtendedNumber]);
                right != k_RightFunctions.end())
            {
                i.words[k_ExtendedNumber] = right->second;
            }
            break;
        case spv::OpShiftLeftLogical:
        case spv::OpShiftRightLogical:
        case spv::OpShiftRightArithmetic:
            MaskCount(i.words[4]);
            break;
        case spv::OpSNegate:
            if (m_Types.at(ComponentType(i.type)).words[3] == 0) // uint
            {
                // spirv-opt takes -(x / c) for x / -c, but not ~(x / c) + 1.
                const Id inverted = Put(spv::OpNot, i.type, {i.words[3]});
                PutAs(i.result, spv::OpIAdd, i.type, {inverted, Constant(i.type, 1)});
                return;
            }
            break;
        case spv::OpUDiv:
        case spv::OpUMod:
            if (!IsConstantOf(i.words[4], [](std::uint32_t n) { return n != 0; }))
            {
                PutDivision(i);
                return;
            }
            break;
        case spv::OpConvertFToS:
        case spv::OpConvertFToU:
            if (WidthOf(m_TypeOf.at(i.words[3])) == 32 && WidthOf(i.type) == 32)
            {
                PutConversion(i);
                return;
            }
            break;
        default:
            break;
        }
        m_Body.insert(m_Body.end(), i.words.begin(), i.words.end());
    }

    /// x - y * trunc(x / y) of their sizes, with the sign of x. Where the quotient is rounded up to
    /// a whole number, or a device divides less exactly, that is off by one y.
    void PutRemainder(const SpirvInstruction& i)
    {
        const Id type = i.type;
        const Id x = i.words[3];
        const Id zero = Null(type);
        const Id truth = Truth(type);
        const Id size = Put(spv::OpExtInst, type, {m_Functions, GLSLstd450FAbs, x});
        const Id divisor = Put(spv::OpExtInst, type, {m_Functions, GLSLstd450FAbs, i.words[4]});
        const Id quotient = Put(spv::OpFDiv, type, {size, divisor});
        const Id whole = Put(spv::OpExtInst, type, {m_Functions, GLSLstd450Trunc, quotient});
        const Id product = Put(spv::OpFMul, type, {divisor, whole});
        const Id rest = Put(spv::OpFSub, type, {size, product});
        const Id above = Put(spv::OpFAdd, type, {rest, divisor});
        const Id below = Put(spv::OpFSub, type, {rest, divisor});
        const Id isLow = Put(spv::OpFOrdLessThan, truth, {rest, zero});
        const Id raised = Put(spv::OpSelect, type, {isLow, above, rest});
        const Id isHigh = Put(spv::OpFOrdGreaterThanEqual, truth, {rest, divisor});
        const Id right = Put(spv::OpSelect, type, {isHigh, below, raised});
        const Id negative = Put(spv::OpFNegate, type, {right});
        const Id isNegative = Put(spv::OpFOrdLessThan, truth, {x, zero});
        PutAs(i.result, spv::OpSelect, type, {isNegative, negative, right});
    }

    void MaskCount(Id& count)
    {
        if (!IsConstantOf(count, [](std::uint32_t n) { return n <= k_CountMask; }))
        {
            const Id type = m_TypeOf.at(count);
            count = Put(spv::OpBitwiseAnd, type, {count, Constant(type, k_CountMask)});
        }
    }

    /// Puts the division of uints. In SPIR-V a division by 0 is undefined.
    void PutDivision(const SpirvInstruction& i)
    {
        const Id divisor = i.words[4];
        const Id isZero = Put(spv::OpIEqual, Truth(i.type), {divisor, Null(m_TypeOf.at(divisor))});
        const Id all = Constant(i.type, std::numeric_limits<std::uint32_t>::max());
        const Id safe = Put(spv::OpSelect, i.type, {isZero, all, divisor});
        const Id divided = Put(static_cast<spv::Op>(i.op), i.type, {i.words[3], safe});
        PutAs(i.result, spv::OpSelect, i.type, {isZero, all, divided});
    }

    /// Puts what `put` makes of the type of a component, x and y, each component for itself:
    /// NVIDIA's driver (580.159) is wrong about the remainder of two constant vectors, and
    /// spirv-opt works out what is constant for single numbers only.
    template <typename Operation>
    void PutForEachComponent(const SpirvInstruction& i, Operation&& put)
    {
        const std::uint32_t count = Components(i.type);
        if (count == 1)
        {
            PutAs(i.result, spv::OpCopyObject, i.type, {put(i.type, i.words[3], i.words[4])});
            return;
        }
        const Id type = ComponentType(i.type);
        SpirvWords parts = {(3 + count) << 16 | spv::OpCompositeConstruct, i.type, i.result};
        for (std::uint32_t component = 0; component < count; ++component)
        {
            const Id x = Put(spv::OpCompositeExtract, type, {i.words[3], component});
            const Id y = Put(spv::OpCompositeExtract, type, {i.words[4], component});
            parts.push_back(put(type, x, y));
        }
        m_Body.insert(m_Body.end(), parts.begin(), parts.end());
    }

    /// The divisor, with 1 in place of -1. The least int divided by -1 is no int; drivers and
    /// spirv-opt divide as the processor does, which ends the program.
    Id PutSafeDivisor(Id divisor)
    {
        const Id type = m_TypeOf.at(divisor);
        return Put(spv::OpSelect, type, {PutIsMinusOne(divisor), Constant(type, 1), divisor});
    }
    Id PutIsMinusOne(Id divisor)
    {
        const Id type = m_TypeOf.at(divisor);
        return Put(spv::OpIEqual, Truth(type), {divisor, Constant(type, k_MinusOne)});
    }

    bool IsNeverMinusOne(Id divisor) const
    {
        return IsConstantOf(divisor, [](std::uint32_t n) { return n != k_MinusOne; });
    }

    /// x - x / y * y, with the sign of x. Vulkan leaves OpSRem and OpSMod undefined where one of
    /// the two is negative, and NVIDIA's driver takes both for unsigned there; of OpSDiv it does
    /// not.
    void PutSignedRemainder(const SpirvInstruction& i)
    {
        const bool isSafe = IsNeverMinusOne(i.words[4]);
        PutForEachComponent(i,
                            [this, isSafe](Id type, Id x, Id y)
                            {
                                const Id divisor = isSafe ? y : PutSafeDivisor(y);
                                const Id quotient = Put(spv::OpSDiv, type, {x, divisor});
                                const Id product = Put(spv::OpIMul, type, {quotient, divisor});
                                return Put(spv::OpISub, type, {x, product});
                            });
    }

    void PutSignedDivision(const SpirvInstruction& i)
    {
        PutForEachComponent(
            i,
            [this](Id type, Id x, Id y)
            {
                const Id divided = Put(spv::OpSDiv, type, {x, PutSafeDivisor(y)});
                const Id negated = Put(spv::OpSNegate, type, {x});
                return Put(spv::OpSelect, type, {PutIsMinusOne(y), negated, divided});
            });
    }

    /// 1 where x has reached the edge, which NaN never has; 0 before it, to SPIR-V.
    void PutStep(const SpirvInstruction& i)
    {
        constexpr std::size_t k_Edge = 5; // words
        constexpr std::size_t k_X = 6;
        const Id isReached =
            Put(spv::OpFOrdGreaterThanEqual, Truth(i.type), {i.words[k_X], i.words[k_Edge]});
        const Id one = Constant(i.type, std::bit_cast<std::uint32_t>(1.0f));
        PutAs(i.result, spv::OpSelect, i.type, {isReached, one, Null(i.type)});
    }

    /// To SPIR-V what the integer cannot hold is undefined.
    void PutConversion(const SpirvInstruction& i)
    {
        const bool isSigned = i.op == spv::OpConvertFToS;
        const Id x = i.words[3];
        const Id from = m_TypeOf.at(x);
        const Id truth = Truth(from);
        const auto number = [&](float value)
        {
            return Constant(from, std::bit_cast<std::uint32_t>(value));
        };
        const Id inside =
            Put(spv::OpExtInst, from,
                {m_Functions, GLSLstd450NClamp, x, isSigned ? number(-k_IntEnd) : Null(from),
                 number(isSigned ? k_LargestInt : k_LargestUint)});
        const Id cut = Put(static_cast<spv::Op>(i.op), i.type, {inside});
        const Id isAbove =
            Put(spv::OpFOrdGreaterThanEqual, truth, {x, number(isSigned ? k_IntEnd : k_UintEnd)});
        const Id largest =
            Constant(i.type, isSigned ? std::uint32_t{std::numeric_limits<std::int32_t>::max()}
                                      : std::numeric_limits<std::uint32_t>::max());
        if (!isSigned) // NaN was clamped to 0
        {
            PutAs(i.result, spv::OpSelect, i.type, {isAbove, largest, cut});
            return;
        }
        const Id clamped = Put(spv::OpSelect, i.type, {isAbove, largest, cut});
        const Id isNumber = Put(spv::OpFOrdEqual, truth, {x, x});
        PutAs(i.result, spv::OpSelect, i.type, {isNumber, clamped, Null(i.type)});
    }

    // Types and constants.

    std::uint32_t Components(Id type) const
    {
        return ComponentType(type) == type ? 1 : m_Types.at(type).words[3];
    }
    Id ComponentType(Id type) const
    {
        const auto known = m_Types.find(type);
        const bool isVector = known != m_Types.end() && known->second.op == spv::OpTypeVector;
        return isVector ? known->second.words[2] : type;
    }
    std::uint32_t WidthOf(Id type) const { return m_Types.at(ComponentType(type)).words[2]; }

    /// bool, or the vector of them that is as long.
    Id Truth(Id type)
    {
        const std::uint32_t count = Components(type);
        if (m_Bools[1] == 0)
        {
            m_Bools[1] = Declare({spv::OpTypeBool, m_Bound});
        }
        if (m_Bools[count] == 0)
        {
            m_Bools[count] = Declare({spv::OpTypeVector, m_Bound, m_Bools[1], count});
        }
        return m_Bools[count];
    }

    Id Null(Id type)
    {
        Id& null = m_Nulls[type];
        null = null == 0 ? Declare({spv::OpConstantNull, type, m_Bound}) : null;
        return null;
    }

    /// Returns a constant with these 32 bits in every component.
    Id Constant(Id type, std::uint32_t bits)
    {
        Id& constant = m_Made[{type, bits}];
        if (constant == 0 && Components(type) == 1)
        {
            constant = Declare({spv::OpConstant, type, m_Bound, bits});
        }
        else if (constant == 0)
        {
            const Id component = Constant(ComponentType(type), bits);
            SpirvWords words = {spv::OpConstantComposite, type, m_Bound};
            words.resize(words.size() + Components(type), component);
            constant = Declare(std::move(words));
        }
        return constant;
    }

    /// @param words  the first is the operation, one is the next free id
    Id Declare(SpirvWords words)
    {
        words[0] |= static_cast<std::uint32_t>(words.size()) << 16;
        m_Declarations.insert(m_Declarations.end(), words.begin(), words.end());
        return m_Bound++;
    }

    // Instructions.

    void PutAs(Id result, spv::Op op, Id type, std::initializer_list<std::uint32_t> operands)
    {
        const auto size = static_cast<std::uint32_t>(operands.size() + 3);
        m_Body.insert(m_Body.end(), {size << 16 | op, type, result});
        m_Body.insert(m_Body.end(), operands);
    }
    Id Put(spv::Op op, Id type, std::initializer_list<std::uint32_t> operands)
    {
        PutAs(m_Bound, op, type, operands);
        m_TypeOf[m_Bound] = type;
        return m_Bound++;
    }

    std::vector<SpirvInstruction> m_Instructions;
    SpirvWords m_Result; ///< header and declarations as they were
    SpirvWords m_Declarations;
    SpirvWords m_Body;
    Id m_Bound;
    Id m_Functions = 0; ///< the set of GLSL.std.450
    std::unordered_map<Id, Id> m_TypeOf;
    std::unordered_map<Id, SpirvInstruction> m_Types; ///< numbers, and vectors of all kinds
    std::unordered_map<Id, SpirvWords> m_Constants;   ///< each component's first word
    std::unordered_map<Id, Id> m_Nulls;               ///< by type
    std::map<std::pair<Id, std::uint32_t>, Id> m_Made;
    Id m_Bools[5] = {}; ///< types by components
};

} // namespace

void UseDirect3DArithmetic(SpirvWords& spirv)
{
    spirv = ArithmeticRewriter(spirv).Rewrite();
}

} // namespace limn

#include "arithmetic/ArithmeticTable.h"
#include "vulkan/compute/ComputeRun.h"

#include <bit>
#include <cctype>
#include <cmath>
#include <sstream>

// The table of HLSL's arithmetic on the device: with numbers that it reads from a buffer, as single
// ones and as vectors, and with numbers that stand in the program.

namespace limn::test
{

namespace
{

class HlslArithmeticGpu : public GpuTest
{
};

std::string TypeName(char type, int width)
{
    const std::string name = type == 'f' ? "float" : type == 'i' ? "int" : "uint";
    return width > 1 ? name + std::to_string(width) : name;
}

/// Functions that rows of the table call, for each width.
std::string Helpers()
{
    std::string text;
    for (int width = 1; width <= 4; ++width)
    {
        const std::string f = TypeName('f', width);
        const auto add = [&](const std::string& function)
        {
            text += function + "\n";
        };
        add(f + " Rest(" + f + " x) { " + f + " whole; return modf(x, whole); }");
        add(f + " Whole(" + f + " x) { " + f + " whole; modf(x, whole); return whole; }");
        add(f + " Mantissa(" + f + " x) { " + f + " e; return frexp(x, e); }");
        add(f + " Exponent(" + f + " x) { " + f + " e; frexp(x, e); return e; }");
        add(f + " Sine(" + f + " x) { " + f + " s, c; sincos(x, s, c); return s; }");
        add(f + " Cosine(" + f + " x) { " + f + " s, c; sincos(x, s, c); return c; }");
        add(TypeName('i', width) + " GivenInt(" + f + " x) { " + TypeName('i', width) +
            " given = x; return given; }");
        add(TypeName('u', width) + " GivenUint(" + f + " x) { " + TypeName('u', width) +
            " given = x; return given; }");
        for (const char type : {'f', 'i', 'u'})
        {
            const std::string t = TypeName(type, width);
            add(t + " Assigned(" + t + " x, " + t + " y) { x %= y; return x; }");
        }
        const std::string i = TypeName('i', width);
        add(i + " Divided(" + i + " x, " + i + " y) { x /= y; return x; }");
        add(i + " ShiftedLeft(" + i + " x, " + i + " y) { x <<= y; return x; }");
        add(i + " ShiftedRight(" + i + " x, " + i + " y) { x >>= y; return x; }");
    }
    return text;
}

/// The text with other words.
std::string Replace(const std::string& text, const std::map<std::string, std::string>& words)
{
    const auto isLetter = [](char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    std::string result;
    for (std::size_t i = 0; i < text.size();)
    {
        std::size_t end = i;
        while (end < text.size() && isLetter(text[end]))
        {
            ++end;
        }
        const std::string word = text.substr(i, std::max<std::size_t>(end - i, 1));
        const auto found = words.find(word);
        result += found == words.end() ? word : found->second;
        i += word.size();
    }
    return result;
}

std::map<std::string, std::string> TypeWords(int width)
{
    const std::string size = width > 1 ? std::to_string(width) : "";
    return {{"FLOAT", "float" + size},
            {"INT", "int" + size},
            {"UINT", "uint" + size},
            {"BOOL", "bool" + size}};
}

constexpr const char* k_Names[] = {"X", "Y", "Z"};

/// Kernels that work rows of the table out, and what these gave.
class ArithmeticProgram
{
public:
    explicit ArithmeticProgram(int width) : m_Width(width) {}

    /// The numbers come from a buffer.
    void AddAtRunTime(const ArithmeticRow& row)
    {
        const std::size_t groups = Begin(row);
        const std::size_t operands = row.calls[0].size();
        m_Body += "if (id.x < " + std::to_string(groups) + ")\n{\n";
        for (std::size_t k = 0; k < operands; ++k)
        {
            const char type = row.calls[0][k].type;
            std::string parts;
            for (int c = 0; c < m_Width; ++c)
            {
                const std::string word = "_In[" +
                                         std::to_string(m_In.size() + static_cast<std::size_t>(c)) +
                                         " + id.x * " + std::to_string(m_Width) + "]";
                parts += (c > 0 ? ", " : "") + (type == 'f'   ? "asfloat(" + word + ")"
                                                : type == 'i' ? "asint(" + word + ")"
                                                              : word);
            }
            const std::string name = TypeName(type, m_Width);
            m_Body += "    " + name + " " + k_Names[k] + " = " + name + "(" + parts + ");\n";
            for (std::size_t call = 0; call < groups * Size(); ++call)
            {
                m_In.push_back(CallAt(row, call)[k].bits);
            }
        }
        Write(row, Replace(row.hlsl, TypeWords(m_Width)), "id.x");
        m_Body += "}\n";
        m_Groups = std::max(m_Groups, groups);
    }

    /// The numbers stand where they are used, or are the values of constants.
    void AddFolded(const ArithmeticRow& row)
    {
        const std::size_t groups = Begin(row);
        for (std::size_t group = 0; group < groups; ++group)
        {
            auto words = TypeWords(m_Width);
            m_Body += "{\n";
            for (std::size_t k = 0; k < row.calls[0].size(); ++k)
            {
                const std::string name = TypeName(row.calls[0][k].type, m_Width);
                std::string parts;
                for (std::size_t c = 0; c < Size(); ++c)
                {
                    parts += (c > 0 ? ", " : "") + CallAt(row, group * Size() + c)[k].literal;
                }
                if (m_Width == 1)
                {
                    words[k_Names[k]] = parts;
                }
                else
                {
                    m_Body += "    const " + name + " " + k_Names[k] + " = " + name + "(" + parts +
                              ");\n";
                }
            }
            Write(row, Replace(row.hlsl, words), std::to_string(group));
            m_Body += "}\n";
        }
    }

    void Run()
    {
        m_In.resize(std::max<std::size_t>(m_In.size(), 1));
        const auto shader = MakeKernel(
            "32, 1, 1", Helpers() + "StructuredBuffer<uint> _In; RWStructuredBuffer<uint> _Out;",
            m_Body);
        const auto in = MakeBuffer(m_In);
        const auto out = MakeBuffer(std::vector<std::uint32_t>(m_Results));
        CommandBuffer cmd;
        cmd.SetComputeBufferParam(shader, 0, "_In", in);
        cmd.SetComputeBufferParam(shader, 0, "_Out", out);
        cmd.DispatchCompute(shader, shader->FindKernel("K"), static_cast<int>(m_Groups + 31) / 32,
                            1, 1);
        RunCommands(cmd);
        m_Out = DataOf<std::uint32_t>(*out);
    }

    std::uint32_t Result(std::size_t row, std::size_t call) const
    {
        return m_Out[m_Begins[row] + call];
    }

private:
    std::size_t Size() const { return static_cast<std::size_t>(m_Width); }

    /// The last vector is filled up with the first calls.
    static const Operands& CallAt(const ArithmeticRow& row, std::size_t index)
    {
        return row.calls[index % row.calls.size()];
    }

    /// @return  how many vectors of calls the row has
    std::size_t Begin(const ArithmeticRow& row)
    {
        const std::size_t groups = (row.calls.size() + Size() - 1) / Size();
        m_Begins.push_back(m_Results);
        m_Results += groups * Size();
        return groups;
    }

    void Write(const ArithmeticRow& row, const std::string& expression, const std::string& group)
    {
        const std::string type = TypeName(row.result, m_Width);
        const std::string value =
            row.result == 'u' ? "(" + type + ")(" + expression + ")" : expression;
        m_Body += "    " + type + " result = " + value + ";\n";
        for (int c = 0; c < m_Width; ++c)
        {
            m_Body += "    _Out[" + std::to_string(m_Begins.back() + static_cast<std::size_t>(c)) +
                      " + " + group + " * " + std::to_string(m_Width) + "] = asuint(result" +
                      (m_Width > 1 ? "[" + std::to_string(c) + "]" : "") + ");\n";
        }
    }

    int m_Width;
    std::string m_Body;
    std::vector<std::uint32_t> m_In;
    std::vector<std::uint32_t> m_Out;
    std::vector<std::size_t> m_Begins; ///< each row's first result
    std::size_t m_Results = 0;
    std::size_t m_Groups = 1;
};

double Decode(std::uint32_t bits, char type)
{
    return type == 'f'   ? static_cast<double>(std::bit_cast<float>(bits))
           : type == 'i' ? static_cast<double>(static_cast<std::int32_t>(bits))
                         : static_cast<double>(bits);
}

bool IsSwiftShader()
{
    return SharedDevice().deviceName().find("SwiftShader") != std::string::npos;
}

bool IsRest(double got, const Outcome& wanted)
{
    const bool hasSign = got == 0.0 || std::signbit(got) == std::signbit(wanted.divided);
    const double distance = std::abs(got - wanted.value);
    return hasSign && std::abs(got) < wanted.divisor &&
           std::min(distance, std::abs(distance - wanted.divisor)) <= wanted.slack;
}

bool IsRight(double got, const Outcome& wanted, const ArithmeticRow& row)
{
    if (wanted.open || (wanted.byDriver && IsSwiftShader()))
    {
        return true;
    }
    if (wanted.divisor > 0.0)
    {
        return IsRest(got, wanted);
    }
    if (std::isnan(wanted.value) || std::isnan(got))
    {
        return std::isnan(wanted.value) && std::isnan(got);
    }
    const double nearest =
        row.result == 'f' ? static_cast<double>(static_cast<float>(wanted.value)) : wanted.value;
    return got == nearest ||
           std::abs(got - wanted.value) <= row.absolute + row.tolerance * std::abs(wanted.value);
}

std::string Complaint(const ArithmeticRow& row, const Operands& operands, double got, double wanted)
{
    std::ostringstream text;
    text.precision(9);
    text << row.hlsl << " of";
    for (const Operand& operand : operands)
    {
        text << " " << operand.literal;
    }
    text << " is " << got << " instead of " << wanted << "\n";
    return text.str();
}

using AddRow = void (ArithmeticProgram::*)(const ArithmeticRow&);

/// What is wrong, a few lines for each row.
std::string Mismatches(const std::vector<ArithmeticRow>& rows, ArithmeticProgram program,
                       AddRow add)
{
    constexpr int k_Lines = 3; // of a row
    for (const ArithmeticRow& row : rows)
    {
        (program.*add)(row);
    }
    program.Run();
    std::string report;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        int lines = 0;
        const ArithmeticRow& row = rows[i];
        for (std::size_t call = 0; call < row.calls.size() && lines < k_Lines; ++call)
        {
            const Outcome wanted = row.oracle(row.calls[call]);
            const double got = Decode(program.Result(i, call), row.result);
            if (!IsRight(got, wanted, row))
            {
                report += Complaint(row, row.calls[call], got, wanted.value);
                ++lines;
            }
        }
    }
    return report;
}

/// Of the whole table.
///
/// @param atOnce     rows in one program
/// @param mostCalls  of a row; of one with more, some from all over it
std::string Mismatches(int width, AddRow add, std::size_t atOnce, std::size_t mostCalls)
{
    std::string report;
    std::vector<ArithmeticRow> rows;
    const auto flush = [&]
    {
        report += Mismatches(rows, ArithmeticProgram(width), add);
        rows.clear();
    };
    for (ArithmeticRow row : ArithmeticRows())
    {
        if (width > 1 && !row.isComponentwise)
        {
            continue;
        }
        const std::size_t step = (row.calls.size() + mostCalls - 1) / mostCalls;
        std::vector<Operands> calls;
        for (std::size_t i = 0; i < row.calls.size(); i += step)
        {
            calls.push_back(row.calls[i]);
        }
        row.calls = std::move(calls);
        rows.push_back(std::move(row));
        if (rows.size() == atOnce)
        {
            flush();
        }
    }
    if (!rows.empty())
    {
        flush();
    }
    return report;
}

std::string MismatchesAtRunTime(int width)
{
    return Mismatches(width, &ArithmeticProgram::AddAtRunTime, 16, 1000);
}

/// Each call is code of its own, which the compilers take their time for.
std::string MismatchesOfConstants(int width)
{
    return Mismatches(width, &ArithmeticProgram::AddFolded, 4, 40);
}

} // namespace

TEST_F(HlslArithmeticGpu, IsRightForNumbersAtRunTime)
{
    EXPECT_EQ("", MismatchesAtRunTime(1));
}

TEST_F(HlslArithmeticGpu, IsRightForVectorsAtRunTime)
{
    for (const int width : {2, 3, 4})
    {
        EXPECT_EQ("", MismatchesAtRunTime(width)) << width;
    }
}

TEST_F(HlslArithmeticGpu, IsRightForConstantNumbers)
{
    EXPECT_EQ("", MismatchesOfConstants(1));
}

TEST_F(HlslArithmeticGpu, IsRightForConstantVectors)
{
    EXPECT_EQ("", MismatchesOfConstants(3));
}

} // namespace limn::test

#include "values/Snippet.h"
#include "vulkan/compute/ComputeRun.h"

#include <bit>
#include <cstdlib>
#include <iostream>

// HLSL that is made by chance gives on the device what it gives in double on the CPU.
// LIMN_VALUES_SEED is the first snippet's seed, LIMN_VALUES_COUNT how many there are; with
// LIMN_VALUES_PRINT each is printed.

#ifndef LIMN_VALUES_COUNT
#define LIMN_VALUES_COUNT 200
#endif

namespace limn::test
{

namespace
{

using snippets::Input;
using snippets::Numbers;
using snippets::Snippet;

class HlslSnippetsGpu : public GpuTest
{
};

int Setting(const char* name, int otherwise)
{
    const char* const text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

const std::vector<Input> k_SnippetInputs = {
    {{1, 0.5, -2, 3}, {1, -2, 3, 0}},
    {{-0.25, 4, 0, 1.5}, {5, 0, -1, 7}},
    {{2, -1, 0.75, -3}, {2, 4, 6, -3}},
    {{0, 1, -0.5, 2.5}, {0, 3, -4, 1}},
};

double Decode(std::uint32_t bits, snippets::Scalar scalar)
{
    return scalar == snippets::Scalar::Bool || isFloating(scalar)
               ? static_cast<double>(std::bit_cast<float>(bits))
           : scalar == snippets::Scalar::Uint
               ? static_cast<double>(bits)
               : static_cast<double>(std::bit_cast<std::int32_t>(bits));
}

std::vector<snippets::Scalar> PartsOf(const Snippet& snippet)
{
    std::vector<snippets::Scalar> parts;
    for (const snippets::Variable& result : snippet.results)
    {
        const auto more = result.type.Parts();
        parts.insert(parts.end(), more.begin(), more.end());
    }
    return parts;
}

/// What the snippets give, for each the results of one input behind those of another.
std::vector<std::uint32_t> RunSnippets(const std::vector<Snippet>& all)
{
    std::string declarations =
        "StructuredBuffer<float4> _Floats; StructuredBuffer<int4> _Integers; "
        "RWStructuredBuffer<uint> _Out;\n";
    std::string body;
    std::size_t size = 0;
    for (const Snippet& snippet : all)
    {
        const std::size_t count = PartsOf(snippet).size();
        declarations += Print(snippet);
        body += snippet.name + "(index, " + std::to_string(size) + " + index * " +
                std::to_string(count) + ");\n";
        size += count * k_SnippetInputs.size();
    }
    std::vector<float> floats;
    std::vector<std::int32_t> integers;
    for (const Input& input : k_SnippetInputs)
    {
        floats.insert(floats.end(), input.floats.begin(), input.floats.end());
        integers.insert(integers.end(), input.integers.begin(), input.integers.end());
    }
    const auto shader = MakeKernel("4, 1, 1", declarations, body);
    CommandBuffer cmd;
    const auto make = [](const auto& data)
    {
        auto buffer = std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured,
                                                       static_cast<int>(data.size() / 4), 16);
        buffer->SetData(data);
        return buffer;
    };
    const auto out = MakeBuffer(std::vector<std::uint32_t>(size, 0xcdcdcdcd));
    cmd.SetComputeBufferParam(shader, 0, "_Floats", make(floats));
    cmd.SetComputeBufferParam(shader, 0, "_Integers", make(integers));
    cmd.SetComputeBufferParam(shader, 0, "_Out", out);
    cmd.DispatchCompute(shader, shader->FindKernel("K"), 1, 1, 1);
    RunCommands(cmd);
    return DataOf<std::uint32_t>(*out);
}

/// The first difference of a snippet, with the snippet.
std::string Difference(const Snippet& snippet, const std::vector<std::uint32_t>& given,
                       std::size_t begin)
{
    const auto parts = PartsOf(snippet);
    for (const Input& input : k_SnippetInputs)
    {
        const Numbers wanted = Interpret(snippet, input);
        for (std::size_t i = 0; i < parts.size(); ++i)
        {
            const double got = Decode(given[begin + i], parts[i]);
            if (got != wanted[i])
            {
                return "result " + std::to_string(i) + " of " + snippet.name + " for input " +
                       std::to_string(&input - k_SnippetInputs.data()) + " is " +
                       std::to_string(got) + " instead of " + std::to_string(wanted[i]) + ":\n" +
                       Print(snippet);
            }
        }
        begin += parts.size();
    }
    return "";
}

std::string Differences(const std::vector<Snippet>& all)
{
    std::vector<std::uint32_t> given;
    try
    {
        given = RunSnippets(all);
    }
    catch (const std::exception& error)
    {
        if (all.size() == 1)
        {
            return error.what() + std::string(" in:\n") + Print(all[0]);
        }
        std::string report;
        for (const Snippet& snippet : all)
        {
            report += Differences({snippet});
        }
        return report;
    }
    std::string report;
    std::size_t begin = 0;
    for (const Snippet& snippet : all)
    {
        report += Difference(snippet, given, begin);
        begin += PartsOf(snippet).size() * k_SnippetInputs.size();
    }
    return report;
}

} // namespace

TEST_F(HlslSnippetsGpu, GiveWhatTheyGiveInDouble)
{
    constexpr int k_AtOnce = 20; // in one program
    const int seed = Setting("LIMN_VALUES_SEED", 1);
    const int count = Setting("LIMN_VALUES_COUNT", LIMN_VALUES_COUNT);
    const bool isLavapipe = SharedDevice().deviceName().find("llvmpipe") != std::string::npos;
    std::vector<Snippet> some;
    std::uint64_t hash = 14695981039346656037u; // FNV-1a, to compare what two compilers make
    for (int i = 0; i < count; ++i)
    {
        some.push_back(Generate(static_cast<std::uint64_t>(seed + i), k_SnippetInputs, isLavapipe));
        const std::string text = Print(some.back());
        for (const char c : text)
        {
            hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
        }
        if (Setting("LIMN_VALUES_PRINT", 0) != 0)
        {
            std::cout << text << std::flush;
        }
        if (some.size() == k_AtOnce || i + 1 == count)
        {
            const std::string differences = Differences(some);
            EXPECT_TRUE(differences.empty()) << differences;
            some.clear();
        }
    }
    std::cout << count << " snippets from seed " << seed << " on, whose text has the hash "
              << std::hex << hash << std::dec << "\n";
}

} // namespace limn::test

#include "ShaderTestSupport.h"
#include "library/FunctionGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/DrawError.h>
#include <sstream>
#include <vulkan/GpuTestDevice.h>
#include <vulkan/GpuTestFrame.h>

namespace limn::test
{

namespace
{

glm::dvec4 AsFloats(const glm::dvec4& v)
{
    return glm::dvec4(glm::vec4(v));
}

std::string Text(const glm::dvec4& v)
{
    std::ostringstream text;
    text.precision(9);
    text << "(" << v.x << ", " << v.y << ", " << v.z << ", " << v.w << ")";
    return text.str();
}

/// How many tolerances apart; infinite where one is no number and the other is.
double Distance(double got, double wanted, const Tolerance& tolerance)
{
    if (std::isnan(got) || std::isnan(wanted))
    {
        return std::isnan(got) == std::isnan(wanted) ? 0.0 : HUGE_VAL;
    }
    if (got == wanted)
    {
        return 0.0;
    }
    static const bool hasExactSines =
        SharedDevice().deviceName().find("llvmpipe") != std::string::npos;
    const double sines = hasExactSines ? 0.0 : tolerance.sines * std::ldexp(1.0, -11);
    return std::abs(got - wanted) /
           (tolerance.absolute + sines + tolerance.relative * std::abs(wanted));
}

std::string Complaint(const std::string& hlsl, const GridInput& input, std::size_t component,
                      double got, double wanted)
{
    std::ostringstream text;
    text.precision(9);
    text << hlsl << " at a=" << Text(input.a) << " b=" << Text(input.b) << " c=" << Text(input.c)
         << ": component " << component << " is " << got << " instead of " << wanted << "\n";
    return text.str();
}

void Append(std::vector<std::byte>& bytes, const void* data, std::size_t size)
{
    const auto* first = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

UniformSlice AddBytes(CompiledFrame& frame, std::uint32_t binding, std::vector<std::byte> bytes)
{
    frame.uniformData.resize((frame.uniformData.size() + 255) / 256 * 256);
    const auto offset = static_cast<std::uint32_t>(frame.uniformData.size());
    const auto size = static_cast<std::uint32_t>(bytes.size());
    Append(frame.uniformData, bytes.data(), bytes.size());
    return {binding, offset, size};
}

/// The bytes of a buffer whose members take their values from the map.
std::vector<std::byte> Fill(const UniformBuffer& buffer,
                            const std::map<std::string, std::vector<float>>& globals)
{
    std::vector<std::byte> bytes(buffer.size);
    for (const UniformMember& member : buffer.members)
    {
        const auto found = globals.find(member.name);
        if (found != globals.end())
        {
            const std::size_t size =
                std::min<std::size_t>(member.size, found->second.size() * sizeof(float));
            std::memcpy(bytes.data() + member.offset, found->second.data(), size);
        }
    }
    return bytes;
}

/// What all draws share: everything but the inputs.
DrawBindings SharedBindings(CompiledFrame& frame, const PropertyLayout& layout,
                            const std::map<std::string, std::vector<float>>& globals,
                            const std::map<std::string, std::shared_ptr<const Texture2D>>& textures)
{
    DrawBindings bindings;
    for (const UniformBuffer& buffer : layout.buffers)
    {
        if (buffer.name != "limn_Grid")
        {
            bindings.uniforms.push_back(AddBytes(frame, buffer.binding, Fill(buffer, globals)));
        }
    }
    for (const TextureBinding& texture : layout.textures)
    {
        const auto sampler = texture.combinedSampler ? std::optional(SamplerState{}) : std::nullopt;
        const auto found = textures.find(texture.name);
        const std::shared_ptr<const Texture> bound =
            found != textures.end() ? found->second : DefaultTexture("white", texture.dimension);
        bindings.textures.push_back({texture.binding, bound, sampler});
    }
    for (const SamplerBinding& sampler : layout.samplers)
    {
        SamplerState state;
        state.comparison = sampler.comparison;
        bindings.samplers.push_back({sampler.binding, state});
    }
    if (!layout.storageBuffers.empty())
    {
        bindings.perDrawBinding = layout.storageBuffers.at(0).binding;
    }
    return bindings;
}

template <typename T>
std::vector<GridInput> CombineAll(const std::vector<T>& as, const std::vector<T>& bs,
                                  const std::vector<T>& cs,
                                  const std::function<glm::dvec4(const T&)>& widen)
{
    std::vector<GridInput> inputs;
    for (const T& a : as)
    {
        for (const T& b : bs)
        {
            for (const T& c : cs)
            {
                inputs.push_back({widen(a), widen(b), widen(c)});
            }
        }
    }
    return inputs;
}

} // namespace

std::vector<GridInput> Combine(const std::vector<double>& a, const std::vector<double>& b,
                               const std::vector<double>& c)
{
    return CombineAll<double>(a, b, c, [](double x) { return glm::dvec4(x, 0.0, 0.0, 0.0); });
}

std::vector<GridInput> CombineVectors(const std::vector<glm::dvec3>& a,
                                      const std::vector<glm::dvec3>& b,
                                      const std::vector<glm::dvec3>& c)
{
    return CombineAll<glm::dvec3>(a, b, c, [](const glm::dvec3& v) { return glm::dvec4(v, 0.0); });
}

std::vector<glm::dvec3> UnitVectors()
{
    std::vector<glm::dvec3> vectors = {{1, 0, 0},
                                       {-1, 0, 0},
                                       {0, 1, 0},
                                       {0, -1, 0},
                                       {0, 0, 1},
                                       {0, 0, -1},
                                       {1, 1, 1},
                                       {-1, 1, -1},
                                       {0.3, -0.9, 0.2},
                                       {-0.5, 0.1, 0.8},
                                       {1e-4, 0.9999, 1e-4},
                                       {0.6, -0.8, 0}};
    for (glm::dvec3& v : vectors)
    {
        v /= std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    }
    return vectors;
}

std::vector<glm::dvec3> Colors()
{
    return {{0, 0, 0},       {1, 1, 1},          {1, 0, 0},     {0, 1, 0},
            {0, 0, 1},       {0.5, 0.5, 0.5},    {0.2, 0.7, 1}, {0.01, 0.002, 0.03},
            {0.9, 0.4, 0.1}, {0.25, 0.75, 0.25}, {4, 2, 0.5},   {100, 50, 1}};
}

std::shared_ptr<const Texture2D> MakeTexture(int width, int height,
                                             const std::function<glm::vec4(int x, int y)>& texel)
{
    std::vector<std::byte> bytes;
    for (int i = 0; i < width * height; ++i)
    {
        const glm::vec4 value = texel(i % width, i / width);
        Append(bytes, &value, sizeof(value));
    }
    return std::make_shared<Texture2D>("texels", width, height, GraphicsFormat::R32G32B32A32_SFloat,
                                       std::move(bytes));
}

std::string CoreInclude(const std::string& name)
{
    return "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/" + name +
           ".hlsl\"\n";
}

FunctionGrid::FunctionGrid(std::string declarations, ProgramLanguage language)
    : m_Declarations(std::move(declarations)), m_Language(language)
{
}

void FunctionGrid::Add(std::string hlsl, std::vector<GridInput> inputs, Oracle oracle,
                       Tolerance tolerance)
{
    for (GridInput& input : inputs)
    {
        input = {AsFloats(input.a), AsFloats(input.b), AsFloats(input.c)};
    }
    m_Functions.push_back({std::move(hlsl), std::move(inputs), std::move(oracle), tolerance});
}

void FunctionGrid::SetGlobal(const std::string& name, std::vector<float> values)
{
    m_Globals[name] = std::move(values);
}

void FunctionGrid::SetTexture(const std::string& name, std::shared_ptr<const Texture2D> texture)
{
    m_Textures[name] = std::move(texture);
}

std::size_t FunctionGrid::Width() const
{
    std::size_t width = 1;
    for (const Function& function : m_Functions)
    {
        width = std::max(width, function.inputs.size());
    }
    return width;
}

std::string FunctionGrid::Program() const
{
    const std::string count = std::to_string(Width() * 3);
    std::string text = m_Declarations + R"(
cbuffer limn_Grid { uint4 limn_Function; float4 limn_Inputs[)" +
                       count + R"(]; };
float4 limn_Widen(float v) { return float4(v, 0, 0, 0); }
float4 limn_Widen(float2 v) { return float4(v, 0, 0); }
float4 limn_Widen(float3 v) { return float4(v, 0); }
float4 limn_Widen(float4 v) { return v; }
float4 limn_Widen(bool v) { return float4(v ? 1.0 : 0.0, 0, 0, 0); }
float4 limn_Widen(int v) { return float4(v, 0, 0, 0); }
float4 limn_Widen(uint v) { return float4(v, 0, 0, 0); }
float4 vert(uint id : SV_VertexID) : SV_POSITION
{
    return float4(id == 1 ? 3.0 : -1.0, id == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
float4 frag(float4 limn_Position : SV_POSITION) : SV_Target
{
    uint limn_Column = (uint)limn_Position.x * 3;
    float4 a = limn_Inputs[limn_Column];
    float4 b = limn_Inputs[limn_Column + 1];
    float4 c = limn_Inputs[limn_Column + 2];
    float4 limn_Result = 0;
    switch (limn_Function.x)
    {
)";
    for (std::size_t i = 0; i < m_Functions.size(); ++i)
    {
        text += "    case " + std::to_string(i) + ": limn_Result = limn_Widen(" +
                m_Functions[i].hlsl + "); break;\n";
    }
    return text + "    default: break;\n    }\n    return limn_Result;\n}\n";
}

Image FunctionGrid::Draw() const
{
    const auto width = static_cast<int>(Width());
    const PassPtr pass = ShaderCompiler(options).Compile(test::Program(Program(), m_Language));
    const TargetPtr target = MakeTarget(width, static_cast<int>(m_Functions.size()),
                                        GraphicsFormat::R32G32B32A32_SFloat);
    CompiledFrame frame = FrameOf({ClearPass(target)}, target);
    frame.perDraw = {perDraw};
    const DrawBindings shared = SharedBindings(frame, pass->layout, m_Globals, m_Textures);
    const auto grid = std::find_if(pass->layout.buffers.begin(), pass->layout.buffers.end(),
                                   [](const UniformBuffer& b) { return b.name == "limn_Grid"; });
    for (std::size_t row = 0; row < m_Functions.size(); ++row)
    {
        std::vector<std::byte> bytes;
        const std::array<std::uint32_t, 4> index = {static_cast<std::uint32_t>(row), 0, 0, 0};
        Append(bytes, index.data(), sizeof(index));
        for (const GridInput& input : m_Functions[row].inputs)
        {
            const std::array<glm::vec4, 3> floats = {input.a, input.b, input.c};
            Append(bytes, floats.data(), sizeof(floats));
        }
        DrawBindings bindings = shared;
        if (grid != pass->layout.buffers.end()) // else every function is 0 whatever the input
        {
            bytes.resize(grid->size);
            bindings.uniforms.push_back(AddBytes(frame, grid->binding, std::move(bytes)));
        }
        DrawCommand draw = MakeDraw(frame, pass, nullptr, PlainState(), bindings);
        draw.vertexCount = 3;
        auto& commands = frame.passes[0].commands;
        commands.emplace_back(SetViewportCommand{{0, static_cast<int>(row), width, 1}});
        commands.emplace_back(draw);
    }
    SharedDevice().Execute(frame);
    return ReadRows(*target);
}

std::string FunctionGrid::Mismatches() const
{
    const Image image = Draw();
    std::string report;
    for (std::size_t row = 0; row < m_Functions.size(); ++row)
    {
        const Function& function = m_Functions[row];
        double worst = 1.0;
        std::string line;
        for (std::size_t column = 0; column < function.inputs.size(); ++column)
        {
            const GridInput& input = function.inputs[column];
            const auto got = TexelFloat(image, static_cast<int>(column), static_cast<int>(row));
            const Values wanted = function.oracle(input.a, input.b, input.c);
            for (std::size_t i = 0; i < wanted.size(); ++i)
            {
                const auto value = static_cast<double>(got[i]);
                const double distance = Distance(value, wanted[i], function.tolerance);
                if (distance > worst)
                {
                    worst = distance;
                    line = Complaint(function.hlsl, input, i, value, wanted[i]);
                }
            }
        }
        report += line;
    }
    return report;
}

void FunctionGrid::Run() const
{
    try
    {
        EXPECT_EQ("", Mismatches());
    }
    catch (const DrawError& error)
    {
        const std::string reason = error.what();
        // The driver that the tests run on where none is asked for lacks nothing that they need.
        if (std::getenv("LIMN_TEST_DEVICE") == nullptr ||
            reason.find(", which the device lacks") == std::string::npos)
        {
            throw;
        }
        GTEST_SKIP() << reason;
    }
}

} // namespace limn::test

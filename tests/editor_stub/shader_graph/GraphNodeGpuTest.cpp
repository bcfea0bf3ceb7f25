// Nodes of shader graphs are compared with their formulas in double (Shader Graph's manual,
// "Node Library").

#include "GraphText.h"
#include "TemporaryFolder.h"
#include "library/FunctionGrid.h"
#include "shader_graph/GraphShader.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <sstream>
#include <vulkan/GpuTestDevice.h>

namespace limn::test
{
namespace
{

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

constexpr double k_Pi = 3.14159265358979323846;

/// Nodes that are computed of the vectors a, b and c.
class NodeValues : public GpuTest
{
protected:
    struct Node
    {
        std::string type;
        std::string inputs; ///< "A DynamicVector a.xyz, B Vector1 b.x": names, kinds, connections
        std::string output; ///< "Out DynamicVector"
        std::string fields{};
    };

    /// Adds a node, and expects what the oracle gives.
    void Expect(const Node& node, const std::vector<GridInput>& inputs, const Oracle& oracle,
                const Tolerance& tolerance = {})
    {
        const std::string name = "Node" + std::to_string(m_Functions.size());
        m_Declarations += FunctionOf(name, node);
        m_Functions.push_back({name + "(a, b, c)", inputs, oracle, tolerance});
    }

    void Run()
    {
        FunctionGrid grid("#include "
                          "\"Packages/com.unity.render-pipelines.universal/ShaderLibrary/"
                          "ShaderGraphFunctions.hlsl\"\n"
                          "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/"
                          "Texture.hlsl\"\n#include \"limn/GraphNodes.hlsl\"\n" +
                          m_Declarations);
        for (const Function& function : m_Functions)
        {
            grid.Add(function.hlsl, function.inputs, function.oracle, function.tolerance);
        }
        grid.SetGlobal("_ScreenParams", {64, 32, 0, 0});
        grid.Run();
    }

private:
    struct Function
    {
        std::string hlsl;
        std::vector<GridInput> inputs;
        Oracle oracle;
        Tolerance tolerance;
    };

    /// Returns a function that has a graph's code for the node in it.
    std::string FunctionOf(const std::string& name, const Node& node)
    {
        GraphText graph;
        std::string slots;
        std::istringstream parts(node.inputs);
        int number = 0;
        std::vector<std::string> sources;
        for (std::string part; std::getline(parts, part, ',');)
        {
            std::istringstream words(part);
            std::string slot;
            std::string kind;
            std::string source;
            words >> slot >> kind >> source;
            slots += std::to_string(number++) + " " + slot + " " + kind + ",";
            const std::size_t width = source.size() - source.find('.') - 1;
            sources.push_back(graph.Property("Vector" + std::to_string(width), source, "",
                                             "Vector" + std::to_string(width)));
        }
        const std::string id = graph.Node(
            node.type, slots + ">" + std::to_string(number) + " " + node.output, node.fields);
        for (std::size_t i = 0; i < sources.size(); ++i)
        {
            graph.Connect(sources[i], 0, id, static_cast<int>(i));
        }
        const std::string block = graph.Block("SurfaceDescription.BaseColor", "0 In DynamicVector");
        graph.Connect(id, number, block, 0);
        m_Folder.Write("a.shadergraph", graph.text());

        const GraphFile file(m_Folder / "a.shadergraph");
        const GraphFiles none = [](const std::string&)
        {
            return std::filesystem::path();
        };
        GraphSurroundings around{none};
        GraphCode code(file, GraphStage::Screen, around);
        const GraphNode* result = file.FindNodeOfType("Block");
        const GraphValue value = code.InputOf(*result, result->slots.front());
        EXPECT_TRUE(around.problems.empty()) << node.type;
        EXPECT_TRUE(code.inputs().empty()) << node.type;
        return value.type + " " + name + "(float4 a, float4 b, float4 c)\n{\n" + code.body() +
               "    return " + value.text + ";\n}\n";
    }

    TemporaryFolder m_Folder;
    std::string m_Declarations;
    std::vector<Function> m_Functions;
};

dvec3 Xyz(const dvec4& v)
{
    return {v.x, v.y, v.z};
}

std::vector<GridInput> Places()
{
    std::vector<GridInput> places;
    for (const double x : {0.05, 0.31, 0.5, 0.77, 1.4, -0.6})
        for (const double y : {0.1, 0.42, 0.93, -1.3})
            places.push_back(
                {dvec4(x, y, 0.3, 0.8), dvec4(0.5, 0.4, 0.2, 0.9), dvec4(2, 3, 0.7, 0)});
    return places;
}

std::vector<GridInput> Pairs()
{
    return CombineVectors({{0.2, 0.5, 0.9}, {0.7, 0.1, 0.3}, {0.45, 0.99, 0.05}},
                          {{0.1, 0.6, 0.8}, {0.51, 0.49, 0.02}, {0.95, 0.3, 0.4}},
                          {{0.25, 0.5, 0.75}, {1, 0, 0.5}});
}

/// Applies a formula to each number.
template <typename Formula>
dvec3 Each(const dvec4& a, const dvec4& b, const Formula& formula)
{
    return {formula(a.x, b.x), formula(a.y, b.y), formula(a.z, b.z)};
}

TEST_F(NodeValues, OfArithmeticAreThoseOfTheManual)
{
    const std::string two = "A DynamicVector a.xyz, B DynamicVector b.xyz";
    const std::string one = "In DynamicVector a.xyz";
    const std::string out = "Out DynamicVector";
    using Binary = double (*)(double, double);
    for (const auto& [type, formula] : {std::pair<const char*, Binary>{"Add",
                                                                       [](double a, double b)
                                                                       {
                                                                           return a + b;
                                                                       }},
                                        {"Subtract",
                                         [](double a, double b)
                                         {
                                             return a - b;
                                         }},
                                        {"Multiply",
                                         [](double a, double b)
                                         {
                                             return a * b;
                                         }},
                                        {"Divide",
                                         [](double a, double b)
                                         {
                                             return a / b;
                                         }},
                                        {"Maximum",
                                         [](double a, double b)
                                         {
                                             return std::max(a, b);
                                         }},
                                        {"Minimum",
                                         [](double a, double b)
                                         {
                                             return std::min(a, b);
                                         }},
                                        {"Power", [](double a, double b)
                                         {
                                             return std::pow(a, b);
                                         }}})
    {
        Expect({type, two, out}, Pairs(),
               [formula = formula](const dvec4& a, const dvec4& b, const dvec4&) -> Values
               { return Each(a, b, formula); });
    }
    for (const auto& [type, formula] : {std::pair<const char*, Binary>{"OneMinus",
                                                                       [](double a, double)
                                                                       {
                                                                           return 1 - a;
                                                                       }},
                                        {"Negate",
                                         [](double a, double)
                                         {
                                             return -a;
                                         }},
                                        {"Reciprocal",
                                         [](double a, double)
                                         {
                                             return 1 / a;
                                         }},
                                        {"SquareRoot",
                                         [](double a, double)
                                         {
                                             return std::sqrt(a);
                                         }},
                                        {"Floor",
                                         [](double a, double)
                                         {
                                             return std::floor(a);
                                         }},
                                        {"Fraction",
                                         [](double a, double)
                                         {
                                             return a - std::floor(a);
                                         }},
                                        {"TriangleWave",
                                         [](double a, double)
                                         {
                                             return 2 * std::abs(2 * (a - std::floor(0.5 + a))) - 1;
                                         }},
                                        {"SawtoothWave",
                                         [](double a, double)
                                         {
                                             return 2 * (a - std::floor(0.5 + a));
                                         }},
                                        {"Exponential", [](double a, double)
                                         {
                                             return std::exp(a);
                                         }}})
    {
        Expect({type, one, out}, Pairs(),
               [formula = formula](const dvec4& a, const dvec4& b, const dvec4&) -> Values
               { return Each(a, b, formula); });
    }
    Expect({"Remap", one + ", InMinMax Vector2 b.xy, OutMinMax Vector2 c.xy", out}, Pairs(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           { return c.x + (Xyz(a) - b.x) * (c.y - c.x) / (b.y - b.x); },
           {1e-4, 1e-5});
    Expect({"InverseLerp", two + ", T DynamicVector c.xyz", out}, Pairs(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           { return (Xyz(c) - Xyz(a)) / (Xyz(b) - Xyz(a)); },
           {1e-4, 1e-5});
    Expect({"Modulo", two, out},
           CombineVectors({{0.7, 1.9, -0.8}, {2.3, -1.1, 0.5}}, {{0.3, 0.45, 0.7}}),
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
           { return Each(a, b, [](double v, double n) { return std::fmod(v, n); }); });
    Expect({"Posterize", one + ", Steps DynamicVector c.xyz", out},
           CombineVectors({{0.2, 0.55, 0.9}, {1.3, 0.12, 0.37}}, {{0, 0, 0}}, {{4, 3, 7}}),
           [](const dvec4& a, const dvec4&, const dvec4& c) -> Values
           { return Each(a, c, [](double v, double n) { return std::floor(v * n) / n; }); },
           {1e-4, 1e-5});
    Run();
}

TEST_F(NodeValues, OfVectorsTakeTheShortestAndFillTheLonger)
{
    // Two and four numbers are added as two; a number and four as four.
    Expect({"Add", "A DynamicVector a.xy, B DynamicVector b.xyzw", "Out DynamicVector"}, Pairs(),
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
           { return dvec2(a.x + b.x, a.y + b.y); });
    Expect({"Add", "A DynamicVector a.x, B DynamicVector b.xyzw", "Out DynamicVector"}, Pairs(),
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values { return a.x + b; });
    Expect({"CrossProduct", "A Vector3 a.xy, B Vector3 b.x", "Out Vector3"}, Pairs(),
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
           { return glm::cross(dvec3(a.x, a.y, 0), dvec3(b.x)); });
    Expect({"Split", "In DynamicVector a.xy", "B Vector1"}, Pairs(),
           [](const dvec4&, const dvec4&, const dvec4&) -> Values { return 0.0; });
    Expect(
        {"Combine", "R Vector1 a.x, G Vector1 a.y, B Vector1 b.x, A Vector1 b.y", "RGBA Vector4"},
        Pairs(),
        [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
        { return dvec4(a.x, a.y, b.x, b.y); });
    Expect({"Swizzle", "In DynamicVector a.xyz", "Out Vector2", R"("_maskInput": "zx")"}, Pairs(),
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values { return dvec2(a.z, a.x); });
    Expect({"Flip", "In DynamicVector a.xyz", "Out DynamicVector", R"("m_GreenChannel": true)"},
           Pairs(),
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values
           { return dvec3(a.x, -a.y, a.z); });
    Expect({"ChannelMask", "In DynamicVector a.xyz", "Out DynamicVector", R"("m_ChannelMask": 5)"},
           Pairs(),
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values { return dvec3(a.x, 0, a.z); });
    Run();
}

TEST_F(NodeValues, OfDecisionsAreThoseOfTheManual)
{
    using Compared = bool (*)(double, double);
    int type = 0;
    for (const Compared compare : {Compared([](double a, double b) { return a == b; }),
                                   Compared([](double a, double b) { return a != b; }),
                                   Compared([](double a, double b) { return a < b; }),
                                   Compared([](double a, double b) { return a <= b; }),
                                   Compared([](double a, double b) { return a > b; }),
                                   Compared([](double a, double b) { return a >= b; })})
    {
        Expect({"Comparison", "A Vector1 a.x, B Vector1 b.x", "Out Boolean",
                "\"m_ComparisonType\": " + std::to_string(type++)},
               Combine({0, 1, 2}, {1}),
               [compare](const dvec4& a, const dvec4& b, const dvec4&) -> Values
               { return compare(a.x, b.x) ? 1.0 : 0.0; });
    }
    Expect({"Branch", "Predicate Boolean a.x, True DynamicVector b.xyz, False DynamicVector c.xyz",
            "Out DynamicVector"},
           CombineVectors({{0, 0, 0}, {1, 0, 0}}, {{1, 2, 3}}, {{4, 5, 6}}),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           { return Xyz(a.x != 0 ? b : c); });
    Run();
}

TEST_F(NodeValues, OfCoordinatesAreThoseOfTheManual)
{
    Expect(
        {"TilingAndOffset", "UV UV a.xy, Tiling Vector2 c.xy, Offset Vector2 b.xy", "Out Vector2"},
        Places(),
        [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
        { return dvec2(a.x * c.x + b.x, a.y * c.y + b.y); });
    // The matrix of the manual has its sine where v is multiplied for u.
    Expect({"Rotate", "UV UV a.xy, Center Vector2 b.xy, Rotation Vector1 c.z", "Out Vector2"},
           Places(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const dvec2 d(a.x - b.x, a.y - b.y);
               return dvec2(d.x * std::cos(c.z) + d.y * std::sin(c.z) + b.x,
                            d.y * std::cos(c.z) - d.x * std::sin(c.z) + b.y);
           },
           {1e-4, 1e-5, 2});
    Expect({"Rotate", "UV UV a.xy, Center Vector2 b.xy, Rotation Vector1 c.z", "Out Vector2",
            "\"m_Unit\": 1"},
           Places(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const double r = c.z * k_Pi / 180;
               const dvec2 d(a.x - b.x, a.y - b.y);
               return dvec2(d.x * std::cos(r) + d.y * std::sin(r) + b.x,
                            d.y * std::cos(r) - d.x * std::sin(r) + b.y);
           },
           {1e-4, 1e-5, 2});
    Expect({"Twirl", "UV UV a.xy, Center Vector2 b.xy, Strength Vector1 c.x, Offset Vector2 b.zw",
            "Out Vector2"},
           Places(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const dvec2 d(a.x - b.x, a.y - b.y);
               const double r = c.x * glm::length(d);
               return dvec2(std::cos(r) * d.x - std::sin(r) * d.y + b.x + b.z,
                            std::sin(r) * d.x + std::cos(r) * d.y + b.y + b.w);
           },
           {1e-4, 1e-5, 2});
    Expect({"PolarCoordinates",
            "UV UV a.xy, Center Vector2 b.xy, RadialScale Vector1 c.x, LengthScale Vector1 c.y",
            "Out Vector2"},
           Places(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const dvec2 d(a.x - b.x, a.y - b.y);
               return dvec2(glm::length(d) * 2 * c.x, std::atan2(d.x, d.y) / 6.28 * c.y);
           },
           {1e-4, 1e-4});
    Expect({"Spherize",
            "UV UV a.xy, Center Vector2 b.xy, Strength Vector2 c.xy, Offset Vector2 b.zw",
            "Out Vector2"},
           Places(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const dvec2 d(a.x - b.x, a.y - b.y);
               const double fourth = glm::dot(d, d) * glm::dot(d, d);
               return dvec2(a.x + d.x * fourth * c.x + b.z, a.y + d.y * fourth * c.y + b.w);
           },
           {1e-4, 1e-5});
    // The second of three columns and two rows, counted from above.
    Expect({"Flipbook", "UV UV a.xy, Width Vector1 c.y, Height Vector1 c.x, Tile Vector1 b.x",
            "Out Vector2", "\"m_InvertY\": true"},
           CombineVectors({{0.5, 0.25, 0}}, {{1, 0, 0}, {4, 0, 0}, {7, 0, 0}}, {{2, 3, 0}}),
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
           {
               const int tile = static_cast<int>(b.x) % 6;
               return dvec2((a.x + tile % 3) / 3, (a.y + (tile < 3 ? 1 : 0)) / 2);
           });
    Run();
}

/// Value noise of a lattice of random numbers, in three octaves.
template <typename Random>
double SimpleNoise(dvec2 uv, const Random& random)
{
    double sum = 0;
    for (int octave = 0; octave < 3; ++octave)
    {
        const dvec2 at = uv / std::pow(2.0, octave);
        const dvec2 cell = glm::floor(at);
        const dvec2 f = at - cell;
        const dvec2 s = f * f * (3.0 - 2.0 * f);
        const double bottom = glm::mix(random(cell), random(cell + dvec2(1, 0)), s.x);
        const double top = glm::mix(random(cell + dvec2(0, 1)), random(cell + dvec2(1, 1)), s.x);
        sum += glm::mix(bottom, top, s.y) * std::pow(0.5, 3 - octave);
    }
    return sum;
}

/// Tchou's hash of two whole numbers, in 32 bits.
std::uint32_t Hash(dvec2 cell, std::uint32_t* second = nullptr)
{
    std::uint32_t x = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(cell.x)));
    std::uint32_t y = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(cell.y)));
    y ^= 1103515245U;
    x += y;
    x *= y;
    x ^= x >> 5U;
    x *= 0x27d4eb2dU;
    y ^= x << 3U;
    if (second != nullptr)
    {
        *second = y;
    }
    return x;
}

double Unit(std::uint32_t hash)
{
    return (hash >> 8U) / 16777215.0;
}

TEST_F(NodeValues, OfNoiseAreThoseOfTheHash)
{
    const std::string inputs = "UV UV a.xy, Scale Vector1 c.x";
    Expect(
        {"Noise", inputs, "Out Vector1", "\"m_HashType\": 0"}, Places(),
        [](const dvec4& a, const dvec4&, const dvec4& c) -> Values
        { return SimpleNoise(dvec2(a.x, a.y) * c.x, [](dvec2 cell) { return Unit(Hash(cell)); }); },
        {1e-4, 1e-5});
    Expect({"GradientNoise", inputs, "Out Vector1", "\"m_HashType\": 0"}, Places(),
           [](const dvec4& a, const dvec4&, const dvec4& c) -> Values
           {
               const dvec2 uv = dvec2(a.x, a.y) * c.x;
               const dvec2 cell = glm::floor(uv);
               const dvec2 f = uv - cell;
               const auto corner = [&](double x, double y)
               {
                   const double hash = Unit(Hash(cell + dvec2(x, y))) * 2 - 1;
                   const dvec2 direction =
                       glm::normalize(dvec2(hash - std::floor(hash + 0.5), std::abs(hash) - 0.5));
                   return glm::dot(direction, f - dvec2(x, y));
               };
               const dvec2 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
               return glm::mix(glm::mix(corner(0, 0), corner(0, 1), s.y),
                               glm::mix(corner(1, 0), corner(1, 1), s.y), s.x) +
                      0.5;
           },
           {1e-3, 1e-4});
    Expect({"Voronoi", "UV UV a.xy, AngleOffset Vector1 b.x, CellDensity Vector1 c.y",
            "Out Vector1", "\"m_HashType\": 0"},
           Places(),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const dvec2 uv = dvec2(a.x, a.y) * c.y;
               double nearest = 8;
               for (int y = -1; y <= 1; ++y)
                   for (int x = -1; x <= 1; ++x)
                   {
                       const dvec2 cell = glm::floor(uv) + dvec2(x, y);
                       std::uint32_t second = 0;
                       const double first = Unit(Hash(cell, &second));
                       const dvec2 point(std::sin(Unit(second) * b.x) * 0.5 + 0.5,
                                         std::cos(first * b.x) * 0.5 + 0.5);
                       nearest = std::min(nearest, glm::length(cell + point - uv));
                   }
               return nearest;
           },
           {1e-3, 1e-4, 2});
    Run();
}

TEST_F(NodeValues, OfColoursAreThoseOfTheManual)
{
    const std::string inputs =
        "Base DynamicVector a.xyz, Blend DynamicVector b.xyz, Opacity Vector1 c.y";
    using Mode = double (*)(double base, double blend);
    const std::vector<Mode> modes{
        [](double b, double s) { return 1 - (1 - s) / b; },   // Burn
        [](double b, double s) { return std::min(s, b); },    // Darken
        [](double b, double s) { return std::abs(s - b); },   // Difference
        [](double b, double s) { return b / (1 - s); },       // Dodge
        [](double b, double s) { return b / s; },             // Divide
        [](double b, double s) { return s + b - 2 * s * b; }, // Exclusion
        [](double b, double s)                                // HardLight
        { return s <= 0.5 ? 2 * b * s : 1 - 2 * (1 - b) * (1 - s); },
        [](double b, double s) { return s >= 1 - b ? 1.0 : 0.0; }, // HardMix
        [](double b, double s) { return std::max(s, b); },         // Lighten
        [](double b, double s) { return b + s - 1; },              // LinearBurn
        [](double b, double s) { return b + s; },                  // LinearDodge
        [](double b, double s)                                     // LinearLight
        { return s < 0.5 ? std::max(b + 2 * s - 1, 0.0) : std::min(b + 2 * (s - 0.5), 1.0); },
        [](double b, double s) { return s + 2 * b - 1; },           // LinearLightAddSub
        [](double b, double s) { return b * s; },                   // Multiply
        [](double b, double s) { return 1 - std::abs(1 - s - b); }, // Negation
        [](double b, double s)                                      // Overlay
        { return b <= 0.5 ? 2 * b * s : 1 - 2 * (1 - b) * (1 - s); },
        [](double b, double s) // PinLight
        { return s < 0.5 ? std::min(b, 2 * s) : std::max(2 * (s - 0.5), b); },
        [](double b, double s) { return 1 - (1 - s) * (1 - b); }, // Screen
        [](double b, double s)                                    // SoftLight
        {
            return s < 0.5 ? 2 * b * s + b * b * (1 - 2 * s)
                           : std::sqrt(b) * (2 * s - 1) + 2 * b * (1 - s);
        },
        [](double b, double s) { return b - s; }, // Subtract
        [](double b, double s)                    // VividLight
        { return s < 0.5 ? 1 - (1 - b) / (2 * s) : b / (2 * (1 - s)); },
        [](double, double s)
        {
            return s;
        }}; // Overwrite
    for (std::size_t mode = 0; mode < modes.size(); ++mode)
    {
        const Mode formula = modes[mode];
        Expect({"Blend", inputs, "Out DynamicVector", "\"m_BlendMode\": " + std::to_string(mode)},
               Pairs(),
               [formula = formula](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
               { return glm::mix(Xyz(a), Each(a, b, formula), c.y); },
               {1e-4, 1e-4});
    }
    Expect({"Contrast", "In Vector3 a.xyz, Contrast Vector1 c.x", "Out Vector3"}, Pairs(),
           [](const dvec4& a, const dvec4&, const dvec4& c) -> Values
           { return (Xyz(a) - std::pow(0.5, 2.2)) * c.x + std::pow(0.5, 2.2); },
           {1e-4, 1e-5});
    Expect({"Saturation", "In Vector3 a.xyz, Saturation Vector1 c.x", "Out Vector3"}, Pairs(),
           [](const dvec4& a, const dvec4&, const dvec4& c) -> Values
           {
               const double luma = glm::dot(Xyz(a), dvec3(0.2126729, 0.7151522, 0.0721750));
               return luma + c.x * (Xyz(a) - luma);
           },
           {1e-4, 1e-5});
    Expect({"InvertColors", "In DynamicVector a.xyz", "Out DynamicVector",
            R"("m_RedChannel": true, "m_BlueChannel": true)"},
           Pairs(),
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values
           { return dvec3(1 - a.x, a.y, 1 - a.z); });
    // A third of the circle makes red green, green blue and blue red.
    Expect({"Hue", "In Vector3 a.xyz, Offset Vector1 b.x", "Out Vector3"},
           CombineVectors({{0.8, 0.2, 0.1}, {0.1, 0.9, 0.4}}, {{120, 0, 0}}),
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values
           { return dvec3(a.z, a.x, a.y); },
           {1e-4, 1e-4});
    Expect({"WhiteBalance", "In Vector3 a.xyz, Temperature Vector1 b.x, Tint Vector1 b.y",
            "Out Vector3"},
           CombineVectors({{0.8, 0.2, 0.1}, {0.5, 0.5, 0.5}}, {{0, 0, 0}}),
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values { return Xyz(a); },
           {1e-3, 1e-3});
    Run();
}

TEST_F(NodeValues, OfNormalsAreThoseOfTheManual)
{
    const std::vector<GridInput> normals =
        CombineVectors({{0.1, -0.3, 0.9}, {0.5, 0.2, 0.7}}, {{-0.2, 0.3, 0.8}, {0.4, 0.1, 0.6}},
                       {{0.5, 0, 0}, {2, 0, 0}});
    Expect({"NormalStrength", "In Vector3 a.xyz, Strength Vector1 c.x", "Out Vector3"}, normals,
           [](const dvec4& a, const dvec4&, const dvec4& c) -> Values
           { return dvec3(a.x * c.x, a.y * c.x, glm::mix(1.0, a.z, std::min(c.x, 1.0))); });
    Expect({"NormalBlend", "A Vector3 a.xyz, B Vector3 b.xyz", "Out Vector3"}, normals,
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
           { return glm::normalize(dvec3(a.x + b.x, a.y + b.y, a.z * b.z)); });
    Expect({"NormalBlend", "A Vector3 a.xyz, B Vector3 b.xyz", "Out Vector3", "\"m_BlendMode\": 1"},
           normals,
           [](const dvec4& a, const dvec4& b, const dvec4&) -> Values
           {
               const dvec3 t = Xyz(a) + dvec3(0, 0, 1);
               const dvec3 u = Xyz(b) * dvec3(-1, -1, 1);
               return (t / t.z) * glm::dot(t, u) - u;
           });
    Expect({"NormalReconstructZ", "In Vector2 a.xy", "Out Vector3"}, normals,
           [](const dvec4& a, const dvec4&, const dvec4&) -> Values
           { return glm::normalize(dvec3(a.x, a.y, std::sqrt(1 - a.x * a.x - a.y * a.y))); });
    Expect({"RotateAboutAxis", "In Vector3 a.xyz, Axis Vector3 b.xyz, Rotation Vector1 c.x",
            "Out Vector3", "\"m_Unit\": 0"},
           CombineVectors({{1, 2, 3}}, {{0, 0, 1}, {0, 2, 0}}, {{0.7, 0, 0}}),
           [](const dvec4& a, const dvec4& b, const dvec4& c) -> Values
           {
               const double s = std::sin(c.x);
               const double n = std::cos(c.x);
               return b.z > 0 ? dvec3(a.x * n - a.y * s, a.x * s + a.y * n, a.z)
                              : dvec3(a.x * n + a.z * s, a.y, a.z * n - a.x * s);
           },
           {1e-4, 1e-5, 4});
    Run();
}

} // namespace
} // namespace limn::test

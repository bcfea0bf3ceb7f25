#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limn/core/Image.h>
#include <limn/core/Texture.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace limn::test
{

/// What a function gives: one to four numbers.
struct Values : std::vector<double>
{
    Values(double x) : std::vector<double>{x} {}
    Values(glm::dvec2 v) : std::vector<double>{v.x, v.y} {}
    Values(glm::dvec3 v) : std::vector<double>{v.x, v.y, v.z} {}
    Values(glm::dvec4 v) : std::vector<double>{v.x, v.y, v.z, v.w} {}
};

/// Three vectors that the HLSL calls a, b and c. They are floats on the device, so the oracle gets
/// what the floats are, not what was written.
struct GridInput
{
    glm::dvec4 a{0.0};
    glm::dvec4 b{0.0};
    glm::dvec4 c{0.0};
};

/// The formula in double precision.
using Oracle = std::function<Values(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c)>;

/// |got - wanted| <= absolute + relative * |wanted|, component by component.
struct Tolerance
{
    double relative = 1e-5;
    double absolute = 1e-6;
    /// How often the error of a sine or cosine is in the result. Vulkan lets it be 2^-11; Mesa's
    /// are as good as other functions, so that the other limits are kept there.
    double sines = 0.0;
};

/// Every combination of the values, each in the x of its vector.
std::vector<GridInput> Combine(const std::vector<double>& a, const std::vector<double>& b = {0.0},
                               const std::vector<double>& c = {0.0});
/// Every combination of the vectors.
std::vector<GridInput> CombineVectors(const std::vector<glm::dvec3>& a,
                                      const std::vector<glm::dvec3>& b = {glm::dvec3(0.0)},
                                      const std::vector<glm::dvec3>& c = {glm::dvec3(0.0)});
/// Unit vectors: the axes both ways, diagonals, and some that are close to an axis.
std::vector<glm::dvec3> UnitVectors();
/// Colours from black over dark, mid and white to bright.
std::vector<glm::dvec3> Colors();

/// A texture of floats, texel by texel from the first row on.
std::shared_ptr<const Texture2D> MakeTexture(int width, int height,
                                             const std::function<glm::vec4(int x, int y)>& texel);

/// The line that includes a file of core's ShaderLibrary.
std::string CoreInclude(const std::string& name);

/// Runs functions of a shader library on the device, all in one program, and compares each with an
/// oracle: one draw per function, one texel per input.
class FunctionGrid
{
public:
    /// @param declarations  HLSL that comes first: includes, helper functions
    explicit FunctionGrid(std::string declarations,
                          ProgramLanguage language = ProgramLanguage::Hlsl);

    /// @param hlsl  an expression of 1 to 4 floats (a bool or an int is turned into one) over the
    ///              float4 a, b and c
    void Add(std::string hlsl, std::vector<GridInput> inputs, Oracle oracle,
             Tolerance tolerance = {});

    /// The value of a uniform or of a matrix (column by column), in whichever buffer it lies; those
    /// not named are 0, textures are 1x1 white.
    void SetGlobal(const std::string& name, std::vector<float> values);
    /// What the program finds in a texture; sampled bilinearly, repeated.
    void SetTexture(const std::string& name, std::shared_ptr<const Texture2D> texture);

    PerDrawData perDraw{};         ///< of the object that is drawn
    ShaderCompilerOptions options; ///< what the program is compiled with

    /// Draws on SharedDevice() and adds a failure to the current test for each function that is
    /// off, with its worst input.
    void Run() const;
    /// What Run() complains about, one line per function.
    std::string Mismatches() const;

private:
    struct Function
    {
        std::string hlsl;
        std::vector<GridInput> inputs;
        Oracle oracle;
        Tolerance tolerance;
    };

    std::size_t Width() const;
    std::string Program() const;
    Image Draw() const;

    std::string m_Declarations;
    ProgramLanguage m_Language;
    std::vector<Function> m_Functions;
    std::map<std::string, std::vector<float>> m_Globals;
    std::map<std::string, std::shared_ptr<const Texture2D>> m_Textures;
};

} // namespace limn::test

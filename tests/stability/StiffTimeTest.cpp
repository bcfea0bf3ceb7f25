#include <array>
#include <cmath>
#include <core/renderers/DrawHarness.h>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/features/OutlineEffect.h>
#include <numbers>

namespace limn
{

namespace
{

/// Steps of a frame, from a microsecond to a day, and how long they have been made already.
constexpr std::array<double, 8> k_Steps{1e-6, 1e-4, 1.0 / 144.0, 1.0 / 60.0,
                                        1.0,  60.0, 3600.0,      86400.0};
constexpr std::array<double, 5> k_Starts{0.0, 1.0, 86400.0, 3.1e7, 1e9};

template <typename Visit>
void ForEachTime(int frames, Visit&& visit)
{
    for (const double start : k_Starts)
    {
        for (const double step : k_Steps)
        {
            for (int frame = 0; frame < frames; ++frame)
            {
                visit(start + frame * step);
            }
        }
    }
}

/// gtest compares doubles.
void ExpectNear(long double exact, long double found, long double bound, double time)
{
    EXPECT_LE(std::abs(exact - found), bound) << "at " << time << " s";
}

constexpr long double k_Pi = std::numbers::pi_v<long double>;

TEST(StiffTime, ObjectsTurnByTheExactAngleAfterAnyTime)
{
    for (const float rate : {90.0f, -0.1f, 7200.0f}) // degrees a second
    {
        GameObject object;
        const std::vector<Turn> turns{{&object, glm::quat(1, 0, 0, 0), {0.0f, rate, 0.0f}}};
        ForEachTime(20,
                    [&](double time)
                    {
                        TurnObjects(turns, time);
                        const long double turned = static_cast<long double>(rate) * time;
                        const long double half = std::fmod(turned, 720.0L) / 360.0L * k_Pi;
                        const glm::quat& found = object.transform.localRotation;
                        // Of a half turn and of its opposite quaternion both signs are right.
                        const long double sine = std::sin(half);
                        const long double cosine = std::cos(half);
                        const long double off =
                            std::abs(found.y * cosine - found.w * sine); // sine of the error
                        // What a double holds of the degrees, and a float of less than a turn.
                        const long double held = std::abs(turned) * 0x1p-52L * k_Pi / 360.0L;
                        EXPECT_LE(off, held + 4e-7L) << rate << " a second after " << time;
                        EXPECT_NEAR(1.0f, glm::length(found), 1e-6f);
                    });
    }
}

TEST(StiffTime, PhasesOfColoursAreThoseOfTheWholeTime)
{
    ForEachTime(20,
                [](double time)
                {
                    const double phase = OutlineEffect::Phase(time);
                    EXPECT_TRUE(phase >= 0.0 && phase < 2.0 * std::numbers::pi) << time;
                    const auto rounded = static_cast<long double>(static_cast<float>(phase));
                    const long double exact = 2.0L * static_cast<long double>(time);
                    // 2 pi is off by 2.4e-16 as a double, once for each turn.
                    const long double held = 2.5e-16L * exact / (2 * k_Pi) + 5e-7L;
                    ExpectNear(std::sin(exact), std::sin(rounded), held, time);
                    ExpectNear(std::cos(exact), std::cos(rounded), held, time);
                });
}

/// Frames of a shader that shows one global.
class StiffShaderTime : public testing::Test
{
protected:
    std::vector<float> GlobalAt(double time)
    {
        m_Request.time = time;
        const CompiledFrame frame = *m_Pipeline.RenderSingleCamera(m_Renderer, m_Request).frame;
        FrameCommands data;
        data.uniformData = frame.uniformData;
        for (const PassCommand& command : frame.passes.at(0).commands)
        {
            if (const auto* draw = std::get_if<DrawCommand>(&command))
            {
                return test::ReadUniform<float>(data, {*draw, frame}, "_SinTime", 4);
            }
        }
        ADD_FAILURE() << "nothing is drawn";
        return std::vector<float>(4);
    }

    void SetUp() override
    {
        test::AddCube(m_Scene, "probe", {0, 0, 5},
                      {std::make_shared<Material>(
                          test::ShaderWithProgram("", "float4 _SinTime;", "_SinTime"))});
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = m_Request.height = 8;
    }

    Scene m_Scene;
    Camera m_Camera;
    RecordingDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    UniversalRenderer m_Renderer{test::Compiler()};
    RenderRequest m_Request;
};

TEST_F(StiffShaderTime, SinesAreThoseOfTheTimeInDouble)
{
    ForEachTime(4,
                [this](double time)
                {
                    const std::vector<float> sines = GlobalAt(time);
                    const std::array<double, 4> parts{8.0, 4.0, 2.0, 1.0};
                    for (std::size_t i = 0; i < parts.size(); ++i)
                    {
                        const long double exact =
                            std::sin(static_cast<long double>(time) / parts[i]);
                        ExpectNear(exact, sines[i], 1e-7L, time);
                    }
                });
}

} // namespace

} // namespace limn

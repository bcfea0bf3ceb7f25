#include "report/extremes/Stability.h"

#include "../vulkan/GpuTestDevice.h"
#include "CachedCompiler.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/editor_stub/Overrides.h>
#include <numbers>

#include "report/measure/StudyPicture.h"

namespace limn::study
{
namespace
{

class StiffPicture : public test::GpuTest
{
protected:
    static AssetContext& Assets()
    {
        static AssetContext assets(test::CachedCompiler());
        return assets;
    }

    static SceneAsset Ball(const char* technique, double width)
    {
        SceneAsset asset = EmptyPicture(48, 48);
        AddOutlined(asset, "ball", CreatePrimitive(PrimitiveType::Sphere), Assets())
            .transform.localScale = glm::vec3(20.0f);
        UseTechnique(asset, RequireTechnique(Assets(), technique), width, Assets());
        return asset;
    }
};

/// Shifts the picture by parts of a pixel.
void Shift(StudyPicture& picture, double pixels)
{
    Camera& camera = picture.asset().camera;
    camera.projectionMatrix.reset();
    const glm::dvec3 inClip(2.0 * pixels / picture.asset().width,
                            2.0 * pixels / picture.asset().height, 0.0);
    camera.projectionMatrix =
        glm::translate(glm::dmat4(1.0), inClip) *
        camera.projectionMatrixFor(static_cast<float>(picture.asset().width) /
                                   static_cast<float>(picture.asset().height));
}

TEST_F(StiffPicture, OfAPartThinnerThanAPixelIsFiniteAndWholeForStrokesWhereverItLies)
{
    for (const Technique& technique : Assets().features().techniques())
    {
        for (const double thickness : {0.05, 0.7})
        {
            SCOPED_TRACE(technique.name + ", " + std::to_string(thickness) + " pixels");
            SceneAsset asset = EmptyPicture(40, 36);
            const ScreenTriangles needle = NeedleTriangles({8.3, 11.2}, {31.6, 25.7}, thickness);
            AddShape(asset, "needle", needle, Assets());
            UseTechnique(asset, technique, 4.0, Assets());
            StudyPicture picture(std::move(asset), Assets(), test::SharedDevice());
            const double exact = ExactOutlineCoverage(Silhouette(needle), {4.0}, 40, 36).Sum();
            for (const double shift : {0.0, 1.0 / 16.0, 0.5})
            {
                Shift(picture, shift);
                const Image colors = picture.Colors();
                const BadValues bad = CountBadValues(colors);
                EXPECT_EQ(bad.notFinite, 0);
                if (technique.name != "Selection") // its strength is 3
                {
                    EXPECT_EQ(bad.outOfRange, 0);
                }
                const double area = ChannelOf(colors, 0).Sum();
                EXPECT_LE(area, 2.5 * exact);
                if (technique.name == "Strokes" || technique.name == "Auto")
                {
                    EXPECT_NEAR(area, exact, 0.01 * exact) << "shifted by " << shift;
                }
            }
        }
    }
}

/// The colour of the outline at a time, as half floats.
std::vector<double> ColorsAt(StudyPicture& picture, double seconds)
{
    picture.time = seconds;
    const Image colors = picture.Colors();
    std::vector<double> values;
    for (int channel = 0; channel < 4; ++channel)
    {
        const Coverage part = ChannelOf(colors, channel);
        values.insert(values.end(), part.values.begin(), part.values.end());
    }
    return values;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

// Colours that come back after pi seconds, looked at after a microsecond and after a day.
TEST_F(StiffPicture, OfColoursInTimeChangesAsLittleAsTheyDoHoweverLateItIs)
{
    SceneAsset asset = Ball("Selection", 8.0);
    const std::vector<std::string> varying = {"SelectionOutline.m_VaryingColor=true",
                                              "SelectionOutline.outlineStrength=1"};
    ApplyOverrides(asset, varying, Assets());
    StudyPicture picture(std::move(asset), Assets(), test::SharedDevice());
    const std::vector<double> first = ColorsAt(picture, 0.4);
    EXPECT_GT(*std::ranges::max_element(first), 0.1);
    EXPECT_GT(LargestDifference(first, ColorsAt(picture, 0.4 + 0.7)), 0.1) << "they do change";
    // The mask that is blurred has 8 bits.
    constexpr double k_Step = 2.0 / 255.0;
    constexpr double k_Fastest = 4.0; // a second: 2 of the angle, times two factors that change
    for (const double start : {0.4, 86400.0 * 30.0, 1e7})
    {
        const std::vector<double> before = ColorsAt(picture, start);
        for (const double step : {1e-6, 1e-3, 1e-2})
        {
            EXPECT_LE(LargestDifference(before, ColorsAt(picture, start + step)),
                      k_Step + k_Fastest * step)
                << start << " s, " << step << " s later";
        }
        for (const double periods : {1.0, 27502.0}) // a day
        {
            EXPECT_LE(
                LargestDifference(before, ColorsAt(picture, start + periods * std::numbers::pi)),
                k_Step)
                << start << " s, " << periods << " periods later";
        }
    }
}

// The volume fades within a micrometre, and the camera is 10 km away in the next frame.
TEST_F(StiffPicture, OfACameraThatCrossesABlendInOneFrameIsThatOfOneSideOrTheOther)
{
    SceneAsset asset = Ball("Strokes", 4.0);
    Volume& volume = asset.volumes.at(0);
    volume.isGlobal = false;
    volume.blendDistance = 1e-6f;
    BoxCollider box;
    box.size = glm::vec3(1e4f, 10.0f, 10.0f); // its side is at x = 5000
    volume.colliders = {Collider{box}};
    StudyPicture picture(std::move(asset), Assets(), test::SharedDevice());
    const auto areaAt = [&](float x)
    {
        picture.asset().camera.volumeTrigger = glm::vec3(x, 0.0f, 0.0f);
        const Image colors = picture.Colors();
        const BadValues bad = CountBadValues(colors);
        EXPECT_EQ(bad.notFinite + bad.outOfRange, 0);
        return ChannelOf(colors, 0).Sum();
    };
    const double inside = areaAt(0.0f);
    const double exact = std::numbers::pi * (14.0 * 14.0 - 10.0 * 10.0);
    EXPECT_NEAR(inside, exact, 0.02 * exact);
    const float side = 5000.0f;
    const float beyond = std::nextafter(side, 1e9f); // 0.0005 m
    for (const auto& [x, area] : {std::pair(1e4f, 0.0),
                                  {side, inside},
                                  {beyond, 0.0},
                                  {-side, inside},
                                  {-1e8f, 0.0},
                                  {0.0f, inside}})
    {
        EXPECT_EQ(areaAt(x), area) << x;
    }
}

} // namespace
} // namespace limn::study

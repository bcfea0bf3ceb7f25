#include "features/sky/SkyScene.h"
#include "vulkan/GpuTestFrame.h"

#include <gmock/gmock.h>
#include <random>

namespace limn::test
{
namespace
{

constexpr int k_FaceWidth = 4;
/// How each side looks from inside: forward, right, up; in the order of CubemapFace.
constexpr glm::dvec3 k_Faces[6][3] = {
    {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};
/// The properties of the six-sided shader in that order: "Left [+X]" is its own name for it.
constexpr const char* k_Sides[] = {"_LeftTex", "_RightTex", "_UpTex",
                                   "_DownTex", "_FrontTex", "_BackTex"};

/// Six pictures of noise, linear.
class Faces
{
public:
    Faces()
    {
        std::mt19937 random(7);
        for (auto& face : m_Texels)
        {
            for (int i = 0; i < k_FaceWidth * k_FaceWidth * 4; ++i)
            {
                face.push_back(std::byte(random() % 256));
            }
        }
    }

    std::shared_ptr<const Cubemap> Cube() const
    {
        const SamplerState nearest{FilterMode::Point};
        return std::make_shared<const Cubemap>("noise", k_FaceWidth, GraphicsFormat::R8G8B8A8_UNorm,
                                               m_Texels, nearest);
    }
    /// A picture's first row is its lowest.
    std::shared_ptr<const Texture2D> Picture(std::size_t face) const
    {
        return std::make_shared<const Texture2D>("noise", k_FaceWidth, k_FaceWidth,
                                                 GraphicsFormat::R8G8B8A8_UNorm,
                                                 FlipRows(m_Texels[face], k_FaceWidth));
    }

    struct Place
    {
        std::size_t face = 0;
        double right = 0.0; ///< 0...4
        double down = 0.0;
    };
    static Place PlaceOf(const glm::dvec3& direction)
    {
        Place place;
        double most = 0.0;
        for (std::size_t face = 0; face < 6; ++face)
        {
            const double forward = glm::dot(direction, k_Faces[face][0]);
            if (forward > most)
            {
                most = forward;
                place = {face, glm::dot(direction, k_Faces[face][1]) / forward,
                         -glm::dot(direction, k_Faces[face][2]) / forward};
            }
        }
        place.right = (place.right + 1.0) * k_FaceWidth / 2;
        place.down = (place.down + 1.0) * k_FaceWidth / 2;
        return place;
    }
    glm::dvec3 Texel(std::size_t face, int x, int y) const
    {
        x = std::clamp(x, 0, k_FaceWidth - 1);
        y = std::clamp(y, 0, k_FaceWidth - 1);
        const auto first = static_cast<std::size_t>(y * k_FaceWidth + x) * 4;
        glm::dvec3 value;
        for (std::size_t channel = 0; channel < 3; ++channel)
        {
            value[static_cast<int>(channel)] =
                std::to_integer<int>(m_Texels[face][first + channel]) / 255.0;
        }
        return value;
    }

    /// Nothing so near to a texel's border that floats may look beyond it.
    std::optional<glm::dvec3> Nearest(const glm::dvec3& direction) const
    {
        const Place place = PlaceOf(direction);
        for (const double coordinate : {place.right, place.down})
        {
            if (std::abs(coordinate - std::round(coordinate)) < 1e-3)
            {
                return std::nullopt;
            }
        }
        return Texel(place.face, static_cast<int>(place.right), static_cast<int>(place.down));
    }
    /// Up to the border of a side, where its pixels end.
    std::optional<glm::dvec3> Bilinear(const glm::dvec3& direction) const
    {
        const Place place = PlaceOf(direction);
        for (const double coordinate : {place.right, place.down})
        {
            if (coordinate < 1e-3 || coordinate > k_FaceWidth - 1e-3)
            {
                return std::nullopt;
            }
        }
        const double x = std::floor(place.right - 0.5);
        const double y = std::floor(place.down - 0.5);
        const auto row = [&](int dy)
        {
            const int left = static_cast<int>(x);
            const int top = static_cast<int>(y) + dy;
            return glm::mix(Texel(place.face, left, top), Texel(place.face, left + 1, top),
                            place.right - 0.5 - x);
        };
        return glm::mix(row(0), row(1), place.down - 0.5 - y);
    }

private:
    CubemapFaces m_Texels;
};

class SkyboxGpu : public SkyGpu
{
protected:
    static constexpr glm::vec3 k_Views[] = {{0, 0, 0},   {0, 90, 0}, {0, 180, 0},  {0, -90, 0},
                                            {-90, 0, 0}, {90, 0, 0}, {40, 130, 20}};
    /// Grey 0.5 doubles to this in linear light: nearly one.
    static double Doubled(double grey) { return std::pow((grey + 0.055) / 1.055, 2.4) * 4.5947938; }

    static constexpr double k_Relative = 1.0 / 1024.0; ///< a half's rounding, twice
    /// Samplers may cut a place off after eight bits of a texel (subTexelPrecisionBits), along each
    /// of two axes; neighbours are up to 1 apart.
    static constexpr double k_Weights = 2.0 / 256.0;
    Faces m_Faces;
};

TEST_F(SkyboxGpu, OfACubeMapShowsTheTexelThatTheDirectionMeets)
{
    Sky("Skybox/Cubemap").SetTexture(ShaderPropertyId("_Tex"), m_Faces.Cube());
    for (const glm::vec3& degrees : k_Views)
    {
        Look(degrees);
        ExpectSky(
            [&](const glm::dvec3& ray) -> std::optional<glm::dvec3>
            {
                const auto texel = m_Faces.Nearest(ray);
                return texel ? std::optional(*texel * Doubled(0.5)) : std::nullopt;
            },
            k_Relative, 1e-6);
    }
}

TEST_F(SkyboxGpu, OfACubeMapIsTurnedTintedAndExposed)
{
    Material& sky = Sky("Skybox/Cubemap");
    sky.SetTexture(ShaderPropertyId("_Tex"), m_Faces.Cube());
    sky.SetFloat(ShaderPropertyId("_Rotation"), 35.0f);
    sky.SetFloat(ShaderPropertyId("_Exposure"), 1.7f);
    sky.SetColor(ShaderPropertyId("_Tint"), {0.5f, 0.25f, 0.75f, 0.5f});
    Look({-20.0f, 25.0f, 0.0f});
    const glm::dvec3 factor =
        std::pow(1.7, 2.2) * glm::dvec3(Doubled(0.5), Doubled(0.25), Doubled(0.75));
    // A turn by +35 degrees carries what was at -x' to where is looked: z goes towards -x.
    const glm::dquat back = glm::angleAxis(glm::radians(35.0), glm::dvec3(0, 1, 0));
    ExpectSky(
        [&](const glm::dvec3& ray) -> std::optional<glm::dvec3>
        {
            const auto texel = m_Faces.Nearest(back * ray);
            return texel ? std::optional(*texel * factor) : std::nullopt;
        },
        k_Relative, 1e-6);
}

TEST_F(SkyboxGpu, OfSixSidesShowsEachWhereUnitysPropertySaysItIs)
{
    Material& sky = Sky("Skybox/6 Sided");
    for (std::size_t face = 0; face < 6; ++face)
    {
        sky.SetTexture(ShaderPropertyId(k_Sides[face]), m_Faces.Picture(face));
    }
    sky.SetFloat(ShaderPropertyId("_Exposure"), 0.5f);
    for (const glm::vec3& degrees : k_Views)
    {
        Look(degrees);
        ExpectSky(
            [&](const glm::dvec3& ray) -> std::optional<glm::dvec3>
            {
                const auto texel = m_Faces.Bilinear(ray);
                const double factor = Doubled(0.5) * std::pow(0.555 / 1.055, 2.4);
                return texel ? std::optional(*texel * factor) : std::nullopt;
            },
            k_Relative, k_Weights);
    }
}

TEST_F(SkyboxGpu, OfSixSidesTurnsAsTheCubeMapDoes)
{
    Material& sides = Sky("Skybox/6 Sided");
    for (std::size_t face = 0; face < 6; ++face)
    {
        sides.SetTexture(ShaderPropertyId(k_Sides[face]), m_Faces.Picture(face));
    }
    sides.SetFloat(ShaderPropertyId("_Rotation"), 35.0f);
    const glm::dquat back = glm::angleAxis(glm::radians(35.0), glm::dvec3(0, 1, 0));
    Look({-20.0f, 25.0f, 0.0f});
    ExpectSky(
        [&](const glm::dvec3& ray) -> std::optional<glm::dvec3>
        {
            const auto texel = m_Faces.Bilinear(back * ray);
            return texel ? std::optional(*texel * Doubled(0.5)) : std::nullopt;
        },
        k_Relative, k_Weights);
}

/// A picture of noise in which the top row is the first, each texel a plain area.
class Panorama
{
public:
    Panorama(int width, int height) : m_Size(width, height)
    {
        std::mt19937 random(11);
        for (int i = 0; i < width * height * 4; ++i)
        {
            m_Texels.push_back(std::byte(random() % 256));
        }
    }
    std::shared_ptr<const Texture2D> Picture() const
    {
        SamplerState nearest{FilterMode::Point};
        return std::make_shared<const Texture2D>("noise", m_Size.x, m_Size.y,
                                                 GraphicsFormat::R8G8B8A8_UNorm,
                                                 FlipRows(m_Texels, m_Size.y), nearest);
    }
    /// @param place  from the top left, 0...1; nothing near to a texel's border
    std::optional<glm::dvec3> At(const glm::dvec2& place) const
    {
        const glm::dvec2 texel = place * glm::dvec2(m_Size);
        for (const double coordinate : {texel.x, texel.y})
        {
            if (std::abs(coordinate - std::round(coordinate)) < 1e-3)
            {
                return std::nullopt;
            }
        }
        const auto first = (static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(m_Size.x) +
                            static_cast<std::size_t>(texel.x)) *
                           4;
        glm::dvec3 value;
        for (int channel = 0; channel < 3; ++channel)
        {
            value[channel] =
                std::to_integer<int>(m_Texels[first + static_cast<std::size_t>(channel)]) / 255.0;
        }
        return value;
    }

private:
    glm::ivec2 m_Size;
    std::vector<std::byte> m_Texels;
};

/// Longitude from -x by way of +z, as parts of a turn, and latitude from the top.
glm::dvec2 LongitudeAndLatitude(const glm::dvec3& ray)
{
    constexpr double k_Turn = 6.283185307179586;
    return {std::atan2(-ray.z, ray.x) / k_Turn + 0.5, std::acos(ray.y) / (k_Turn / 2)};
}

TEST_F(SkyboxGpu, OfOnePictureOfAllAroundHasPlusXInItsMiddle)
{
    const Panorama panorama(16, 8);
    Material& sky = Sky("Skybox/Panoramic");
    sky.SetTexture(ShaderPropertyId("_MainTex"), panorama.Picture());
    sky.SetFloat(ShaderPropertyId("_Rotation"), 35.0f);
    const glm::dquat back = glm::angleAxis(glm::radians(35.0), glm::dvec3(0, 1, 0));
    const auto expect = [&](const std::function<std::optional<glm::dvec2>(glm::dvec2)>& place)
    {
        for (const glm::vec3& degrees : k_Views)
        {
            Look(degrees);
            ExpectSky(
                [&](const glm::dvec3& ray) -> std::optional<glm::dvec3>
                {
                    const auto there = place(LongitudeAndLatitude(back * ray));
                    const auto texel = there ? panorama.At(*there) : std::optional(glm::dvec3(0));
                    return texel ? std::optional(*texel * Doubled(0.5)) : std::nullopt;
                },
                k_Relative, 1e-6);
        }
    };
    expect([](const glm::dvec2& place) { return place; });
    sky.SetFloat(ShaderPropertyId("_Layout"), 1.0f); // the left eye's in the left half
    expect([](const glm::dvec2& place) { return glm::dvec2(place.x / 2, place.y); });
    sky.SetFloat(ShaderPropertyId("_Layout"), 2.0f); // and in the upper one
    expect([](const glm::dvec2& place) { return glm::dvec2(place.x, place.y / 2); });
    sky.SetFloat(ShaderPropertyId("_Layout"), 0.0f);
    sky.SetFloat(ShaderPropertyId("_ImageType"), 1.0f); // nothing but half a turn
    expect(
        [](const glm::dvec2& place)
        { return place.x < 0.5 ? std::optional(glm::dvec2(place.x * 2, place.y)) : std::nullopt; });
    sky.SetFloat(ShaderPropertyId("_MirrorOnBack"), 1.0f);
    expect([](const glm::dvec2& place)
           { return glm::dvec2(place.x < 0.5 ? place.x * 2 : place.x * 2 - 1, place.y); });
}

TEST_F(SkyboxGpu, OfOnePictureOfSixFramesIsTheCube)
{
    // The cells of +X -X +Y -Y +Z -Z; the last of the high cross stands upside down.
    const glm::ivec2 wide[] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
    const glm::ivec2 high[] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}};
    for (const glm::ivec2 cells :
         {glm::ivec2(4, 3), glm::ivec2(3, 4), glm::ivec2(6, 1), glm::ivec2(1, 6)})
    {
        const Panorama panorama(cells.x * k_FaceWidth, cells.y * k_FaceWidth);
        Material& sky = Sky("Skybox/Panoramic");
        sky.SetTexture(ShaderPropertyId("_MainTex"), panorama.Picture());
        sky.EnableKeyword("_MAPPING_6_FRAMES_LAYOUT");
        for (const glm::vec3& degrees : k_Views)
        {
            Look(degrees);
            ExpectSky(
                [&](const glm::dvec3& ray) -> std::optional<glm::dvec3>
                {
                    const Faces::Place place = Faces::PlaceOf(ray);
                    const auto face = static_cast<int>(place.face);
                    glm::dvec2 inFace = glm::dvec2(place.right, place.down) / double(k_FaceWidth);
                    const glm::ivec2 cell = cells.x == 4   ? wide[face]
                                            : cells.x == 3 ? high[face]
                                            : cells.x == 6 ? glm::ivec2(face, 0)
                                                           : glm::ivec2(0, face);
                    inFace = cells.x == 3 && face == 5 ? 1.0 - inFace : inFace;
                    const auto texel = panorama.At((glm::dvec2(cell) + inFace) / glm::dvec2(cells));
                    return texel ? std::optional(*texel * Doubled(0.5)) : std::nullopt;
                },
                k_Relative, 1e-6);
        }
    }
}

/// One quad that covers the left half, a twentieth of a metre before the far plane.
GameObject& AddFarQuad(Scene& scene, const Camera& camera, std::shared_ptr<const Material> material)
{
    GameObject& object = scene.Add("far");
    object.transform.localPosition =
        camera.transform.localPosition + glm::vec3(-200.0f, 0.0f, camera.farClipPlane - 0.05f);
    object.transform.localScale = {400.0f, 400.0f, 1.0f};
    object.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Quad), {std::move(material)}};
    return object;
}

TEST_F(SkyboxGpu, LiesBehindTheFarthestObjectWhicheverWayRoundDepthIs)
{
    m_Camera.farClipPlane = 100.0f;
    Sky("Skybox/Cubemap")
        .SetTexture(ShaderPropertyId("_Tex"), DefaultTexture("white", TextureDimension::Cube));
    for (const bool reversed : {true, false})
    {
        ShaderCompilerOptions options;
        options.usesReversedZBuffer = reversed;
        const auto compiler = std::make_shared<ShaderCompiler>(options);
        Scene scene;
        scene.skybox = std::make_shared<Material>(*m_Scene.skybox,
                                                  FindBuiltinShader("Skybox/Cubemap", compiler));
        const auto plain = std::make_shared<Material>(
            FindBuiltinShader("Universal Render Pipeline/Unlit", compiler));
        plain->SetVector(ShaderPropertyId("_BaseColor"), {1.0f, 0.0f, 0.0f, 1.0f});
        AddFarQuad(scene, m_Camera, plain);

        UniversalRenderPipeline pipeline(SharedDevice());
        UniversalRenderer renderer(compiler);
        RenderRequest request;
        request.scene = &scene;
        request.camera = &m_Camera;
        request.width = k_Width;
        request.height = k_Height;
        const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
        const Image picture = SharedDevice().ReadBack(*result.output.rt());
        for (const int y : {0, k_Height / 2, k_Height - 1})
        {
            EXPECT_EQ(Texel8(picture, 2, y), (Rgba8{255, 0, 0, 255})) << reversed;
            EXPECT_GE(Texel8(picture, k_Width - 2, y)[1], 250) << reversed;
        }
    }
}

TEST_F(SkyboxGpu, LiesBehindWhatIsTransparent)
{
    Sky("Skybox/Cubemap")
        .SetTexture(ShaderPropertyId("_Tex"), DefaultTexture("white", TextureDimension::Cube));
    m_Camera.farClipPlane = 100.0f;
    const auto glass = Plain({1.0f, 0.0f, 0.0f});
    glass->SetRenderQueue(3000);
    glass->SetFloat(ShaderPropertyId("_SrcBlend"), 2.0f); // by what is behind: a filter
    glass->SetFloat(ShaderPropertyId("_ZWrite"), 0.0f);
    AddFarQuad(m_Scene, m_Camera, glass);
    PictureRun run(m_Scene, m_Camera, k_Width, k_Height);
    const Field picture = run.Color(nullptr);
    EXPECT_NEAR(picture.At(2, k_Height / 2, 0), Doubled(0.5), 1e-3);
    EXPECT_EQ(picture.At(2, k_Height / 2, 1), 0.0);
    EXPECT_NEAR(picture.At(k_Width - 2, k_Height / 2, 1), Doubled(0.5), 1e-3);
}

std::vector<std::string> NamesOfPasses(const RenderResult& result)
{
    std::vector<std::string> names;
    for (const ExecutedPassReport& pass : result.report.passes)
    {
        names.push_back(pass.name.name());
    }
    return names;
}

TEST_F(SkyboxGpu, IsDrawnBetweenOpaqueAndTransparentObjectsAndOnlyIfTheCameraShowsIt)
{
    Sky("Skybox/Cubemap");
    PictureRun run(m_Scene, m_Camera, 8, 8);
    run.Render(nullptr, true);
    EXPECT_THAT(NamesOfPasses(run.result()),
                testing::ElementsAre("Draw Opaque Objects", "Draw Skybox",
                                     "Draw Transparent Objects", "Final Blit"));
    const std::size_t drawn = run.result().frame->setups.size();
    m_Camera.clearFlags = CameraClearFlags::SolidColor;
    run.Render(nullptr, true);
    EXPECT_THAT(
        NamesOfPasses(run.result()),
        testing::ElementsAre("Draw Opaque Objects", "Draw Transparent Objects", "Final Blit"));
    EXPECT_LT(run.result().frame->setups.size(), drawn);
    const Field plain = run.Color(nullptr);
    m_Camera.clearFlags = CameraClearFlags::Skybox;
    m_Scene.skybox = nullptr;
    EXPECT_EQ(CountDifferent(plain, run.Color(nullptr)), 0) << "no skybox: the background";
}

TEST_F(SkyboxGpu, IsTheSameFarAwayFromTheWorldsOrigin)
{
    Sky("Skybox/Procedural");
    Look({-30.0f, 22.0f, 0.0f});
    PictureRun run(m_Scene, m_Camera, k_Width, k_Height);
    const Field here = run.Color(nullptr);
    for (const float distance : {1e4f, 1e7f})
    {
        m_Camera.transform.localPosition = {distance, -distance, distance / 2};
        const Field there = run.Color(nullptr);
        ASSERT_EQ(here.values.size(), there.values.size());
        for (std::size_t i = 0; i < here.values.size(); ++i)
        {
            ASSERT_NEAR(there.values[i], here.values[i], here.values[i] / 1024.0)
                << "more than one step of a half at " << distance << " m";
        }
    }
}

} // namespace
} // namespace limn::test

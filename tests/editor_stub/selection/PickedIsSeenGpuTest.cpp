#include "SceneFolder.h"
#include "commands/CommandRun.h"
#include "precision/DevicePrecision.h"
#include "selection/SelectionScene.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SelectController.h>
#include <limn/volume/VolumeManager.h>

namespace limn::test
{

namespace
{

constexpr int k_PickedWidth = 77;
constexpr int k_PickedHeight = 49;

/// Objects of all shapes, each of one of the colours that are exact in a picture.
struct Colored : SelectionScene
{
    explicit Colored(bool orthographic)
    {
        camera.orthographic = orthographic;
        camera.orthographicSize = 2.0f;
        camera.backgroundColor = Color{0.0f, 0.0f, 0.0f, 1.0f};
        camera.transform.localRotation = EulerToRotation({10.0f, -15.0f, 5.0f});
        const PrimitiveType types[] = {PrimitiveType::Sphere,   PrimitiveType::Capsule,
                                       PrimitiveType::Cylinder, PrimitiveType::Cube,
                                       PrimitiveType::Quad,     PrimitiveType::Torus,
                                       PrimitiveType::Plane};
        for (int i = 0; i < 7; ++i)
        {
            const auto f = static_cast<float>(i);
            GameObject& object = Add(std::to_string(i + 1), Assets().Primitive(types[i]),
                                     {f * 0.7f - 3.2f, f * 0.13f - 0.4f, 3.0f + f * 0.3f});
            const glm::vec3 turns[] = {{0, 0, 0},   {20, 33, 0}, {40, 66, 0}, {60, 99, 0},
                                       {10, 20, 0}, {80, 50, 0}, {-70, 0, 0}};
            object.transform.localRotation = EulerToRotation(turns[i]);
            object.transform.localScale = i == 6 ? glm::vec3(0.3f) : glm::vec3(1.0f, 1.2f, 1.0f);
            const auto paint = NewMaterial();
            const auto has = [i](int bit)
            {
                return ((i + 1) & bit) != 0 ? 1.0f : 0.0f;
            };
            paint->SetColor(ShaderPropertyId{"_BaseColor"}, Color{has(1), has(2), has(4), 1.0f});
            object.renderer->sharedMaterials = {paint};
        }
    }

    Image Draw()
    {
        UniversalRenderer renderer(Assets().compiler());
        VolumeManager volumes(Assets().volumeComponents());
        VolumeStack stack = volumes.CreateStack();
        UniversalRenderPipeline pipeline(SharedDevice());
        RenderRequest request;
        request.scene = &scene;
        request.camera = &camera;
        request.width = k_PickedWidth;
        request.height = k_PickedHeight;
        request.volumeStack = &stack;
        return SharedDevice().ReadBack(*pipeline.RenderSingleCamera(renderer, request).output.rt());
    }
};

/// "1" to "7", or "" for the background.
std::string NameIn(const Image& image, int x, int y)
{
    const std::size_t at = 4 * static_cast<std::size_t>(y * k_PickedWidth + x);
    const auto bit = [&](std::size_t channel)
    {
        return static_cast<int>(image.texels[at + channel]) > 127 ? 1 << channel : 0;
    };
    const int number = bit(0) + bit(1) + bit(2);
    return number == 0 ? "" : std::to_string(number);
}

/// What is at a pixel and the eight around it.
std::set<std::string> NamesAround(const std::vector<std::string>& names, int x, int y)
{
    std::set<std::string> around;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, k_PickedHeight - 1); ++row)
    {
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, k_PickedWidth - 1);
             ++column)
        {
            around.insert(names[static_cast<std::size_t>(row * k_PickedWidth + column)]);
        }
    }
    return around;
}

class Picking : public testing::TestWithParam<bool>
{
};

} // namespace

// Pixels on an edge may be rounded to either side; there are at most a few, or so many as the
// device's rounding of corners (SubPixel(), to both sides) can carry an edge over the centre of.
TEST_P(Picking, SelectsWhatIsSeenAtEachPixel)
{
    Colored content(GetParam());
    const Image image = content.Draw();
    SelectSettings settings;
    settings.renderingLayers = RenderingLayerMask::FromIndex(8);
    SelectController controller(content.scene, settings);
    std::vector<std::string> names;
    std::set<std::string> seen;
    for (int y = 0; y < k_PickedHeight; ++y)
    {
        for (int x = 0; x < k_PickedWidth; ++x)
        {
            const GameObject* hit =
                controller.GetHitObj(content.camera, k_PickedWidth, k_PickedHeight, x, y);
            seen.insert(names.emplace_back(hit ? hit->name : ""));
        }
    }
    int different = 0;
    int atEdges = 0;
    for (int y = 0; y < k_PickedHeight; ++y)
    {
        for (int x = 0; x < k_PickedWidth; ++x)
        {
            const std::set<std::string> around = NamesAround(names, x, y);
            const std::string drawn = NameIn(image, x, y);
            atEdges += around.size() > 1 ? 1 : 0;
            different += names[static_cast<std::size_t>(y * k_PickedWidth + x)] != drawn ? 1 : 0;
            EXPECT_EQ(around.count(drawn), 1u) << x << ", " << y << " is not near " << drawn;
        }
    }
    EXPECT_THAT(seen, testing::ElementsAre("", "1", "2", "3", "4", "5", "6", "7"));
    EXPECT_LE(different,
              std::max(k_PickedWidth * k_PickedHeight / 1000.0, atEdges * 2.0 * SubPixel()));
}

INSTANTIATE_TEST_SUITE_P(Cameras, Picking, testing::Bool());

TEST(SelectionOptions, OutlineWhatIsClicked)
{
    const SceneFolder folder;
    const std::string scene =
        folder
            .Write(
                "s.scene.yaml",
                "size: [64, 32]\n"
                "camera: {orthographic: true, orthographicSize: 8, position: [0, 0, -9],\n"
                "         backgroundColor: '#000000'}\n"
                "renderingLayers: {8: Selected}\n"
                "renderer:\n"
                "  features:\n"
                "    - {type: ScreenSpaceOutlineRenderFeature, m_LayerMask: Everything,\n"
                "       m_ScreenSpaceOutlineShader: Hidden/ScreenSpaceOutline,\n"
                "       m_RenderingLayerMask: Selected}\n"
                "volumes: [{profile: on.profile.yaml}]\n"
                "materials: {black: {shader: Universal Render Pipeline/Unlit,\n"
                "                    _BaseColor: '#000000'}}\n"
                "objects:\n"
                "  - {name: Left, mesh: cube, scale: 6, position: [-8, 0, 0], material: black}\n"
                "  - {name: Right, mesh: cube, scale: 6, position: [8, 0, 0], material: black}\n")
            .string();
    const auto isLit = [&](const std::vector<std::string>& options)
    {
        const std::string picture = (folder / "p.png").string();
        std::vector<std::string> args{"render", scene, "-o", picture};
        args.insert(args.end(), options.begin(), options.end());
        const CommandRun run = RunCommand(args);
        EXPECT_EQ(0, run.exitCode) << run.err;
        const Image image = ReadPng(picture);
        std::array<bool, 2> halves{};
        for (std::size_t i = 0; i < image.texels.size(); i += 4)
        {
            bool& half = halves[(i / 4) % 64 / 32];
            half = half || image.texels[i] > std::byte{100};
        }
        return halves;
    };
    using Halves = std::array<bool, 2>;
    EXPECT_EQ((Halves{false, false}), isLit({}));
    EXPECT_EQ((Halves{true, false}), isLit({"--select", "Left"}));
    EXPECT_EQ((Halves{true, true}), isLit({"--select", "Left,Right"}));
    EXPECT_EQ((Halves{false, true}), isLit({"--click", "48,16"}));
    EXPECT_EQ((Halves{true, true}), isLit({"--click", "16,16", "--ctrl-click", "48,16"}));
    EXPECT_EQ((Halves{false, true}),
              isLit({"--click", "16,16", "--ctrl-click=48,16", "--ctrl-click", "16,16"}));
    EXPECT_EQ((Halves{true, false}), isLit({"--ctrl-click", "48,16", "--click", "16,16"}));
    EXPECT_EQ((Halves{false, false}), isLit({"--select", "Left", "--click", "0,0"}));
    EXPECT_EQ((Halves{false, false}), isLit({"--select", "Left", "--select", ""}));
}

} // namespace limn::test

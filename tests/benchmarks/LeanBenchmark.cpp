// What an outline that draws nothing costs on the CPU: a frame with the feature less one without
// it, taking turns. Prints; `lean_benchmark --quick` for a smoke run.

#include "NoDevice.h"
#include "Samples.h"
#include "features/OutlineScene.h"

#include <cstring>

namespace limn::benchmarks
{

namespace
{

/// A renderer with the outline or without it, on a scene that both have.
class LeanFrames
{
public:
    LeanFrames(const test::OutlineScene& content, const VolumeStack& volumes, bool hasFeature)
        : m_Content(content), m_Volumes(volumes)
    {
        if (hasFeature)
        {
            test::AddOutline(m_Renderer);
        }
    }

    /// @return microseconds
    double Frame()
    {
        RenderRequest request;
        request.scene = &m_Content.scene;
        request.camera = &m_Content.camera;
        request.width = 1280;
        request.height = 720;
        request.volumeStack = &m_Volumes;
        const auto begin = std::chrono::steady_clock::now();
        m_Pipeline.RenderSingleCamera(m_Renderer, request);
        const std::chrono::duration<double, std::micro> taken =
            std::chrono::steady_clock::now() - begin;
        return taken.count();
    }

private:
    const test::OutlineScene& m_Content;
    const VolumeStack& m_Volumes;
    NoDevice m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    UniversalRenderer m_Renderer{test::Compiler()};
};

void AddObjects(test::OutlineScene& content, int objects)
{
    const auto material = content.scene.Find("Sphere")->renderer->sharedMaterials.front();
    for (int i = 0; i < objects; ++i)
    {
        content.Add(("Cube" + std::to_string(i)).c_str(), PrimitiveType::Cube,
                    {static_cast<float>(i % 10) - 5.0f, 0.0f, 5.0f}, material, false);
    }
}

void SelectNothing(test::OutlineScene& content)
{
    for (const auto& object : content.scene.objects())
    {
        object->renderer->renderingLayerMask = RenderingLayerMask::FromIndex(0);
    }
}

void MoveAway(test::OutlineScene& content)
{
    content.scene.Find("Torus")->transform.localPosition.x = 100.0f;
    content.scene.Find("Cube")->transform.localPosition.x = -100.0f;
}

struct InactiveOutline
{
    const char* name;
    bool isEnabled;
    Color color;
    float width;
    void (*change)(test::OutlineScene&);
};

void Compare(const InactiveOutline& c, int objects, int pairs)
{
    test::OutlineScene content;
    AddObjects(content, objects);
    c.change(content);
    test::BlendedOutline volumes;
    const VolumeStack& stack = volumes.With(c.isEnabled, c.color, c.width);
    LeanFrames with(content, stack, true);
    LeanFrames without(content, stack, false);
    Samples difference;
    Samples whole;
    for (int i = -5; i < pairs; ++i) // the first frames make textures and bindings
    {
        const bool isFirst = i % 2 == 0; // who comes second finds the scene in the caches
        const double before = isFirst ? 0.0 : without.Frame();
        const double outlined = with.Frame();
        const double plain = isFirst ? without.Frame() : before;
        if (i >= 0)
        {
            difference.Add(outlined - plain);
            whole.Add(plain);
        }
    }
    std::printf("%-32s %4d objects: %+7.1f us [%+7.1f %+7.1f] of %8.1f us\n", c.name, objects + 3,
                difference.Median(), difference.Part(0.1), difference.Part(0.9), whole.Median());
}

} // namespace

} // namespace limn::benchmarks

int main(int argc, char** argv)
{
    using namespace limn;
    using namespace limn::benchmarks;
    const bool isQuick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
    const auto nothing = [](test::OutlineScene&) {
    };
    const InactiveOutline cases[] = {
        {"volume off", false, Color::green, 4.0f, nothing},
        {"nothing selected", true, Color::green, 4.0f, SelectNothing},
        {"what is selected off the screen", true, Color::green, 4.0f, MoveAway},
        {"width 0", true, Color::green, 0.0f, nothing},
        {"colour 0", true, Color::clear, 4.0f, nothing}};
    std::printf("an outline that draws nothing: frame with it less frame without, median [tenth "
                "ninetieth part]\n");
    for (const int objects : isQuick ? std::vector<int>{0} : std::vector<int>{0, 100, 1000})
    {
        for (const InactiveOutline& c : cases)
        {
            Compare(c, objects, isQuick ? 3 : 301);
        }
    }
}

// Outline techniques: how far their pictures are from the exact outline, and what they cost. Frames
// with and without the outline take turns in one run; the difference is printed as its median with
// the tenth and ninetieth part. Error figures do not depend on the machine.
//
//   cmake --preset release -DLIMN_BUILD_TESTS=ON
//   cmake --build --preset release --target outline_benchmark
//   build/release/tests/outline_benchmark [--quick] [--pairs N] [--device NAME]
//   [error|kinds|time]...
//
// `kinds` prints a table in Markdown: the mean error of every technique for every kind of mesh that
// nobody tidied.

#include "CachedCompiler.h"
#include "Samples.h"
#include "editor_stub/report/measure/UntidyScene.h"
#include "report/measure/StudyPicture.h"
#include "report/measure/StudyScene.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limn/vulkan/VulkanDevice.h>
#include <limn/vulkan/VulkanError.h>

namespace limn::benchmarks
{

namespace
{

using namespace study;
using namespace test;

struct Options
{
    bool quick = false;
    int pairs = 31;
    std::string device;
    std::vector<std::string> tables;
};

/// Keeps what is compiled for every picture of the run.
AssetContext& Assets(const VulkanDevice& device)
{
    static AssetContext assets = [&device]
    {
        ShaderCompilerOptions options = CachedCompiler();
        options.missingFeatures = device.missingShaderFeatures();
        return AssetContext(std::move(options));
    }();
    return assets;
}

struct Shape
{
    std::string name;
    ScreenTriangles triangles;
};

/// @param scale  1 = discs of 400 pixels across in a picture of 1920 x 1080
std::vector<Shape> Shapes(double scale)
{
    const glm::dvec2 middle = glm::dvec2(960.3, 540.6) * scale;
    const double radius = 200.0 * scale;
    return {{"disc", DiscTriangles(middle, radius)},
            {"ring", RingTriangles(middle, 0.6 * radius, radius)},
            {"star", StarTriangles(middle, 5, 0.4 * radius, radius, 0.3)},
            {"needle 0.3 px", NeedleTriangles(middle - glm::dvec2(0.9, 0.3) * radius,
                                              middle + glm::dvec2(0.9, 0.3) * radius, 0.3)},
            {"two", Together({DiscTriangles(middle - glm::dvec2(0.5, 0.2) * radius, 0.6 * radius),
                              StarTriangles(middle + glm::dvec2(0.4, 0.3) * radius, 7, 0.3 * radius,
                                            0.6 * radius)})}};
}

double Scale(const Options& options)
{
    return options.quick ? 0.05 : 1.0;
}

glm::ivec2 PictureSize(const Options& options)
{
    return glm::ivec2(glm::dvec2(1920.0, 1080.0) * Scale(options));
}

void PrintErrors(VulkanDevice& device, const Options& options)
{
    const std::vector<double> widths =
        options.quick ? std::vector<double>{2} : std::vector<double>{1, 2, 4, 8, 16, 32, 64};
    const glm::ivec2 size = PictureSize(options);
    std::printf("\nError of the outline's coverage, %d x %d; over pixels that are in the outline, "
                "the drawn or the exact one\n%-15s %-14s %5s %9s %9s %8s %8s %9s\n",
                size.x, size.y, "technique", "shape", "width", "mean abs", "rms", "largest", "IoU",
                "width off");
    AssetContext& assets = Assets(device);
    std::vector<Shape> shapes = Shapes(Scale(options));
    shapes.resize(options.quick ? 1 : shapes.size());
    for (const Shape& shape : shapes)
    {
        const Silhouette silhouette(shape.triangles);
        for (const double width : widths)
        {
            const Coverage exact = ExactOutlineCoverage(silhouette, {width}, size.x, size.y);
            for (const Technique& technique : assets.features().techniques())
            {
                if (!technique.noWidth.empty() || width > technique.widestOutline)
                {
                    continue;
                }
                SceneAsset asset = EmptyPicture(size.x, size.y);
                AddShape(asset, "shape", shape.triangles, assets);
                UseTechnique(asset, technique, width, assets);
                const OutlineScore score =
                    ScoreOutline(StudyPicture(std::move(asset), assets, device).Alpha(), exact);
                std::printf("%-15s %-14s %5g %9.5f %9.5f %8.3f %8.4f %+8.2f%%\n",
                            technique.name.c_str(), shape.name.c_str(), width,
                            score.meanAbsoluteError, score.rootMeanSquare, score.largest,
                            score.intersectionOverUnion, 100.0 * (score.areaRatio - 1.0));
            }
        }
    }
}

/// @return the mean error of an outline of 8 pixels; NaN where the device draws no such outline
double UntidyError(VulkanDevice& device, AssetContext& assets, const Technique& technique,
                   PrimitiveType type, Untidiness untidiness)
{
    constexpr double k_PixelsWide = 8.0;
    const SceneAsset model = TidyScene(type, untidiness, assets);
    const Coverage exact =
        ExactOutlineCoverage(OutlinedSilhouette(model), {k_PixelsWide}, model.width, model.height);
    try
    {
        SceneAsset asset = UntidyScene(type, untidiness, assets);
        UseTechnique(asset, technique, k_PixelsWide, assets);
        return ScoreOutline(StudyPicture(std::move(asset), assets, device).Alpha(), exact)
            .meanAbsoluteError;
    }
    catch (const ContractError& error)
    {
        std::fprintf(stderr, "%s: %s\n", technique.name.c_str(), error.what());
        return std::numeric_limits<double>::quiet_NaN();
    }
}

void PrintKinds(VulkanDevice& device, const Options& options)
{
    AssetContext& assets = Assets(device);
    const std::vector<PrimitiveType> types =
        options.quick ? std::vector<PrimitiveType>{PrimitiveType::Cube}
                      : std::vector<PrimitiveType>{PrimitiveType::Cube, PrimitiveType::Torus,
                                                   PrimitiveType::Sphere};
    std::printf("\nMean error of an outline of 8 pixels; the mean of a cube, a torus and a sphere\n"
                "\n| technique |");
    for (const char* kind : k_UntidinessNames)
    {
        std::printf(" %s |", kind);
    }
    std::printf("\n|---|");
    for (std::size_t i = 0; i < k_UntidinessNames.size(); ++i)
    {
        std::printf("---|");
    }
    for (const Technique& technique : assets.features().techniques())
    {
        std::printf("\n| %s%s |", technique.name.c_str(), technique.noWidth.empty() ? "" : "*");
        for (std::size_t i = 0; i < k_UntidinessNames.size(); ++i)
        {
            double sum = 0.0;
            for (const PrimitiveType type : types)
            {
                sum += UntidyError(device, assets, technique, type, static_cast<Untidiness>(i));
            }
            std::printf(" %.5f |", sum / static_cast<double>(types.size()));
        }
    }
    std::printf(
        "\n\n* has no width to be held to: its figures only say what it makes of the kind.\n"
        "Open meshes and those with fins have another silhouette than the tidy mesh and are\n"
        "held to that; all others are held to the exact outline of the tidy mesh.\n");
}

/// Milliseconds of the device in all passes of a new frame.
double DeviceMilliseconds(StudyPicture& picture, VulkanDevice& device)
{
    picture.Render();
    device.Wait();
    double sum = 0.0;
    for (const PassTiming& timing : device.LastFrameTimings())
    {
        sum += timing.milliseconds;
    }
    return sum;
}

/// @param isHdr  then whatever blends keeps the half-float target and its final copy alive
SceneAsset SpherePicture(const glm::ivec2& size, double diameter, bool isHdr, AssetContext& assets)
{
    SceneAsset asset = EmptyPicture(size.x, size.y);
    asset.camera.allowHDR = isHdr;
    GameObject& sphere =
        AddOutlined(asset, "sphere", assets.Primitive(PrimitiveType::Sphere), assets);
    // Flat enough to lie in front of the camera.
    const auto across = static_cast<float>(diameter);
    sphere.transform.localScale = {across, across, std::min(across, 100.0f)};
    return asset;
}

void PrintTime(VulkanDevice& device, const Options& options, const Technique& technique,
               double width, bool isHdr)
{
    AssetContext& assets = Assets(device);
    const auto sphere = [&]
    {
        return SpherePicture(PictureSize(options), 400.0 * Scale(options), isHdr, assets);
    };
    SceneAsset outlined = sphere();
    UseTechnique(outlined, technique, width, assets);
    StudyPicture without(sphere(), assets, device);
    StudyPicture with(std::move(outlined), assets, device);
    DeviceMilliseconds(without, device);
    DeviceMilliseconds(with, device);
    Samples plain;
    Samples added;
    for (int i = 0; i < options.pairs; ++i)
    {
        const double a = DeviceMilliseconds(without, device);
        plain.Add(a);
        added.Add(DeviceMilliseconds(with, device) - a);
    }
    std::printf("%-27s width %2g %s  + %7.2f [%.2f-%.2f]  without %.2f\n", technique.name.c_str(),
                width, isHdr ? "HDR" : "LDR", added.Median(), added.Part(0.1), added.Part(0.9),
                plain.Median());
}

void PrintTimes(VulkanDevice& device, const Options& options)
{
    const glm::ivec2 size = PictureSize(options);
    std::printf("\nDevice ms that the outline of a sphere of %.0f pixels adds to a frame of %d x "
                "%d: median [tenth-ninetieth part], and ms of the frame without it\n",
                400.0 * Scale(options), size.x, size.y);
    for (const bool isHdr : {false, true})
    {
        for (const double width :
             options.quick ? std::vector<double>{8} : std::vector<double>{2, 8, 32})
        {
            for (const Technique& technique : Assets(device).features().techniques())
            {
                if (width <= technique.widestOutline)
                {
                    PrintTime(device, options, technique, width, isHdr);
                }
            }
        }
    }
}

Options ParseOptions(int count, char** arguments)
{
    Options options;
    for (int i = 1; i < count; ++i)
    {
        const std::string argument = arguments[i];
        if (argument == "--quick")
        {
            options.quick = true;
            options.pairs = 1;
        }
        else if (argument == "--pairs" && i + 1 < count)
        {
            options.pairs = std::max(1, std::atoi(arguments[++i]));
        }
        else if (argument == "--device" && i + 1 < count)
        {
            options.device = arguments[++i];
        }
        else
        {
            options.tables.push_back(argument);
        }
    }
    return options;
}

int Run(const Options& options)
{
    VulkanDeviceOptions deviceOptions;
    deviceOptions.device = options.device;
    VulkanDevice device(deviceOptions);
    std::printf("%s\n", device.ChoiceSentence().c_str());
    const std::pair<const char*, void (*)(VulkanDevice&, const Options&)> tables[] = {
        {"error", PrintErrors}, {"kinds", PrintKinds}, {"time", PrintTimes}};
    for (const auto& [name, print] : tables)
    {
        if (options.tables.empty() || std::ranges::count(options.tables, name) > 0)
        {
            print(device, options);
        }
    }
    return 0;
}

} // namespace

} // namespace limn::benchmarks

int main(int count, char** arguments)
{
    try
    {
        return limn::benchmarks::Run(limn::benchmarks::ParseOptions(count, arguments));
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

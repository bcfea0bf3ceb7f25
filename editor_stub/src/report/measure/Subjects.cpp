#include "report/measure/Subjects.h"

#include "report/measure/StudyScene.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace limn::study
{

namespace
{

/// Balls side by side, with gaps as wide as they are.
SceneAsset Balls(const CellId& id, AssetContext& assets)
{
    int count = 0;
    std::from_chars(id.variant.data(), id.variant.data() + id.variant.size(), count);
    SceneAsset asset = EmptyPicture(id.pictureWidth, id.pictureHeight);
    const double aspect = static_cast<double>(id.pictureWidth) / id.pictureHeight;
    const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(count * aspect))));
    const int rows = (count + columns - 1) / columns;
    const glm::dvec2 pitch(static_cast<double>(id.pictureWidth) / columns,
                           static_cast<double>(id.pictureHeight) / std::max(1, rows));
    const auto diameter = static_cast<float>(0.5 * std::min(pitch.x, pitch.y));
    const auto mesh = assets.Primitive(PrimitiveType::Sphere);
    for (int i = 0; i < count; ++i)
    {
        Transform& place = AddOutlined(asset, "ball " + std::to_string(i), mesh, assets).transform;
        place.localPosition = {(i % columns + 0.5) * pitch.x - 0.5 * id.pictureWidth,
                               0.5 * id.pictureHeight - (i / columns + 0.5) * pitch.y, 0.0};
        // Flat enough to lie in front of the camera.
        place.localScale = {diameter, diameter, std::min(diameter, 100.0f)};
    }
    return asset;
}

} // namespace

const std::vector<std::string>& ShapeNames()
{
    static const std::vector<std::string> names = {"disc", "ring", "star", "needle", "two"};
    return names;
}

bool IsShape(const std::string& subject)
{
    return std::ranges::count(ShapeNames(), subject) > 0;
}

ScreenTriangles ShapeTriangles(const std::string& name, int width, int height)
{
    // Off the pixels' raster, so that no technique is lucky.
    const glm::dvec2 middle = 0.5 * glm::dvec2(width, height) + glm::dvec2(0.3, 0.6);
    const double radius = 0.3 * std::min(width, height);
    if (name == "disc")
    {
        return DiscTriangles(middle, radius);
    }
    if (name == "ring")
    {
        return RingTriangles(middle, 0.6 * radius, radius);
    }
    if (name == "star")
    {
        return StarTriangles(middle, 5, 0.4 * radius, radius, 0.3);
    }
    if (name == "needle")
    {
        const glm::dvec2 half = glm::dvec2(0.9, 0.3) * radius;
        return NeedleTriangles(middle - half, middle + half, 0.3);
    }
    if (name == "two")
    {
        return Together(
            {DiscTriangles(middle - glm::dvec2(0.5, 0.2) * radius, 0.6 * radius),
             StarTriangles(middle + glm::dvec2(0.4, 0.3) * radius, 7, 0.3 * radius, 0.6 * radius)});
    }
    throw ContractError("there is no shape '" + name + "'");
}

SceneAsset MakeSubject(const CellId& id, bool isBlack, const std::filesystem::path& scene,
                       AssetContext& assets)
{
    if (id.subject == k_BallsSubject)
    {
        return Balls(id, assets);
    }
    if (IsShape(id.subject))
    {
        SceneAsset asset = EmptyPicture(id.pictureWidth, id.pictureHeight);
        AddShape(asset, id.subject, ShapeTriangles(id.subject, id.pictureWidth, id.pictureHeight),
                 assets);
        return asset;
    }
    SceneAsset asset = LoadScene(scene, assets, InactiveObjects::Check);
    asset.width = id.pictureWidth;
    asset.height = id.pictureHeight;
    MarkOutlined(asset);
    if (isBlack)
    {
        MakeBlack(asset, assets);
    }
    return asset;
}

} // namespace limn::study

#include "report/extremes/ExtremeCase.h"

#include "console/Texts.h"

#include <algorithm>
#include <cmath>
#include <limn/base/ParseWhole.h>
#include <numbers>
#include <sstream>

namespace limn::study
{

namespace
{

constexpr double k_Radius = 0.625;    ///< of the torus, metres
constexpr double k_LargestPart = 0.3; ///< of the picture's height
constexpr double k_LargestRadius = 60.0;

const char* const k_Views[] = {"perspective", "orthographic", "oblique"};
const char* const k_Directions[] = {"reversed", "standard"};
const char* const k_Scalings[] = {"", "mirrored", "singular"};

/// From the camera to the object's middle, metres, for a scale of 1.
double CameraDistance(const ExtremeCase& extreme)
{
    const double part = 2.0 * extreme.ObjectRadius() / extreme.size.y;
    const double halfAngle = extreme.fieldOfView * std::numbers::pi / 360.0;
    return std::max(1.6 * k_Radius, k_Radius / (part * std::tan(halfAngle)));
}

/// A plane before the object that leans by 20 degrees, and a middle that is beside the picture's.
void MakeOblique(Camera& camera, float aspect, double objectDistance, double objectRadius)
{
    glm::dmat4 offCentre = camera.projectionMatrixFor(aspect);
    offCentre[2][0] += 0.06;
    offCentre[2][1] -= 0.04;
    camera.projectionMatrix = offCentre;
    const double lean = std::numbers::pi / 9.0;
    const double distance = 0.3 * (objectDistance - objectRadius);
    camera.projectionMatrix = camera.CalculateObliqueMatrix(
        {-std::sin(lean), 0.0, -std::cos(lean), -distance * std::cos(lean)}, aspect);
}

Camera CameraOf(const ExtremeCase& extreme)
{
    const double distance = CameraDistance(extreme) * extreme.scale;
    const double radius = k_Radius * extreme.scale;
    const double reach = std::sqrt(extreme.depthRatio);
    Camera camera;
    camera.backgroundColor = Color::black;
    camera.fieldOfView = static_cast<float>(extreme.fieldOfView);
    camera.nearClipPlane = static_cast<float>(distance / reach);
    camera.farClipPlane = static_cast<float>(distance * reach);
    // Beside the axis, on no whole pixel.
    camera.transform.localPosition =
        glm::vec3(glm::dvec3(0.113 * radius, 0.071 * radius, -distance));
    camera.orthographic = extreme.view == ExtremeView::Orthographic;
    camera.orthographicSize =
        static_cast<float>(radius * 0.5 * extreme.size.y / std::max(extreme.ObjectRadius(), 1e-3));
    if (extreme.view == ExtremeView::Oblique)
    {
        MakeOblique(camera, static_cast<float>(extreme.size.x) / static_cast<float>(extreme.size.y),
                    distance, radius);
    }
    return camera;
}

glm::vec3 ScaleOf(const ExtremeCase& extreme)
{
    return extreme.scaling == ExtremeScale::Mirrored   ? glm::vec3(-1.0f, 1.0f, 1.0f)
           : extreme.scaling == ExtremeScale::Singular ? glm::vec3(1.0f, 0.0f, 1.0f)
                                                       : glm::vec3(glm::dvec3(extreme.scale));
}

/// A level's name without spaces, which part the levels of a variant: "two-objects".
std::string WithoutSpaces(const std::string& name)
{
    return Replaced(name, " ", "-");
}

/// Takes the level that has this name.
/// @return false if there is none
template <typename Level>
bool TakeName(const auto& names, const std::string& name, Level& level)
{
    const auto found = std::ranges::find(names, name, WithoutSpaces);
    if (found == std::end(names))
    {
        return false;
    }
    level = static_cast<Level>(found - std::begin(names));
    return true;
}

/// Takes "key=value" into the case.
/// @return false if there is no such
bool TakeLevel(ExtremeCase& extreme, const std::string& key, const std::string& value)
{
    if ((key == "view" && TakeName(k_Views, value, extreme.view)) ||
        (key == "z" && TakeName(k_Directions, value, extreme.isStandardZ)) ||
        (key == "mesh" && TakeName(k_UntidinessNames, value, extreme.untidiness)) ||
        (key == "scale" && TakeName(k_Scalings, value, extreme.scaling)))
    {
        return true;
    }
    const double number = ParseWhole<double>(value).value_or(0.0);
    if (!(number > 0.0) || !std::isfinite(number))
    {
        return false;
    }
    extreme.samples = key == "samples" ? static_cast<int>(number) : extreme.samples;
    extreme.depthRatio = key == "ratio" ? number : extreme.depthRatio;
    extreme.fieldOfView = key == "fov" ? number : extreme.fieldOfView;
    extreme.scale = key == "scale" ? number : extreme.scale;
    return key == "samples" || key == "ratio" || key == "fov" || key == "scale";
}

} // namespace

double ExtremeCase::ObjectRadius() const
{
    return std::min(k_LargestPart * size.y, k_LargestRadius);
}

std::string ExtremeCase::Variant() const
{
    std::ostringstream text;
    text << "ratio=" << depthRatio << " fov=" << fieldOfView << " scale=";
    if (scaling == ExtremeScale::Uniform)
    {
        text << scale;
    }
    text << k_Scalings[static_cast<std::size_t>(scaling)] << " samples=" << samples
         << " view=" << k_Views[static_cast<std::size_t>(view)]
         << " z=" << k_Directions[isStandardZ ? 1 : 0]
         << " mesh=" << WithoutSpaces(k_UntidinessNames[static_cast<std::size_t>(untidiness)]);
    return text.str();
}

ExtremeCase ExtremeCase::OfCell(const CellId& cell)
{
    ExtremeCase extreme;
    extreme.width = cell.width;
    extreme.size = {cell.pictureWidth, cell.pictureHeight};
    std::istringstream variant(cell.variant);
    for (std::string part; variant >> part;)
    {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos ||
            !TakeLevel(extreme, part.substr(0, equals), part.substr(equals + 1)))
        {
            throw ContractError("'" + cell.Name() + "' is no cell of the stability sweep: '" +
                                part + "' is not known");
        }
    }
    return extreme;
}

SceneAsset ExtremeCase::Scene(AssetContext& assets, bool isGrey) const
{
    SceneAsset asset;
    asset.width = size.x;
    asset.height = size.y;
    asset.msaaSampleCount = samples;
    asset.camera = CameraOf(*this);
    const auto mesh = MakeUntidy(*assets.Primitive(PrimitiveType::Torus), untidiness);
    for (int i = 0; i < (untidiness == Untidiness::TwoObjects ? 2 : 1); ++i)
    {
        GameObject& torus = AddOutlined(asset, "torus", mesh, assets);
        torus.transform.localRotation = EulerToRotation({-63.0f, 21.0f, 8.0f});
        torus.transform.localScale = ScaleOf(*this);
        if (isGrey)
        {
            auto material = std::make_shared<Material>(*torus.renderer->sharedMaterials.front());
            material->SetColor(ShaderPropertyId("_BaseColor"), {0.5f, 0.5f, 0.5f, 1.0f});
            torus.renderer->sharedMaterials = {std::move(material)};
        }
    }
    return asset;
}

std::vector<int> ExtremeLevels::Counts() const
{
    std::vector<int> counts;
    for (const std::size_t count :
         {depthRatios.size(), widths.size(), sizes.size(), fieldsOfView.size(), scales.size() + 2,
          samples.size(), views.size(), standardZ.size(), meshes.size()})
    {
        counts.push_back(static_cast<int>(count));
    }
    return counts;
}

ExtremeCase ExtremeLevels::At(const Combination& combination) const
{
    const auto level = [&](const auto& list, std::size_t factor)
    {
        return list[static_cast<std::size_t>(combination[factor])];
    };
    ExtremeCase extreme;
    extreme.depthRatio = level(depthRatios, 0);
    extreme.width = level(widths, 1);
    extreme.size = level(sizes, 2);
    extreme.fieldOfView = level(fieldsOfView, 3);
    const auto scale = static_cast<std::size_t>(combination[4]);
    if (scale < scales.size())
    {
        extreme.scale = scales[scale];
    }
    else
    {
        extreme.scaling = scale == scales.size() ? ExtremeScale::Mirrored : ExtremeScale::Singular;
    }
    extreme.samples = level(samples, 5);
    extreme.view = level(views, 6);
    extreme.isStandardZ = level(standardZ, 7);
    extreme.untidiness = level(meshes, 8);
    return extreme;
}

bool ExtremeLevels::IsWorthIt(const Combination& combination) const
{
    const ExtremeCase extreme = At(combination);
    const auto others =
        static_cast<std::ptrdiff_t>(combination.size()) - std::ranges::count(combination, 0);
    if (!std::isfinite(extreme.width))
    {
        return others <= 1;
    }
    const bool isPlain =
        std::max(extreme.size.x, extreme.size.y) <= 256 && extreme.untidiness == Untidiness::None;
    return isPlain || others <= 3;
}

} // namespace limn::study

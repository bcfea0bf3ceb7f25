#pragma once

#include "report/extremes/Pairwise.h"
#include "report/measure/StudyScene.h"
#include "report/measure/UntidyMesh.h"

namespace limn::study
{

/// A camera's way of projecting.
enum class ExtremeView
{
    Perspective,
    Orthographic,
    /// Off-centre perspective with an oblique near plane (Camera::projectionMatrix).
    Oblique
};

/// The scaling of the outlined object.
enum class ExtremeScale
{
    Uniform,  ///< by ExtremeCase::scale; the camera's distance is scaled as well
    Mirrored, ///< (-1, 1, 1)
    Singular  ///< (1, 0, 1): it is flat and its matrix has no inverse
};

/// Extreme settings of a picture. Each by itself is harmless: errors occur where two of them meet.
struct ExtremeCase
{
    double depthRatio = 1e2;   ///< far plane / near plane; the object is at their geometric mean
    double width = 8.0;        ///< in pixels; may be infinite or NaN
    glm::ivec2 size{96, 64};   ///< of the picture, in pixels
    double fieldOfView = 60.0; ///< in degrees; has no effect for ExtremeView::Orthographic
    ExtremeScale scaling = ExtremeScale::Uniform;
    double scale = 1.0;
    int samples = 1; ///< samples of a pixel
    ExtremeView view = ExtremeView::Perspective;
    bool isStandardZ = false;                 ///< see ShaderCompilerOptions::usesReversedZBuffer
    Untidiness untidiness = Untidiness::None; ///< of the object's mesh

    /// Returns everything but width and size, readable and always the same: "ratio=1e+02 fov=60
    /// scale=mirrored samples=4 view=oblique z=reversed mesh=soup".
    std::string Variant() const;
    /// Returns the case that a cell's id describes.
    /// @throws ContractError if the cell's variant is not one that Variant() returns
    static ExtremeCase OfCell(const CellId& cell);

    /// Returns a scene with a torus, black unless `isGrey`, in the rendering layer k_OutlinedLayer
    /// and nothing behind it. It is at most 120 pixels large, however large the picture.
    SceneAsset Scene(AssetContext& assets, bool isGrey) const;
    /// Returns half of the object's size in Scene, in pixels, or less if perspective makes it
    /// smaller.
    double ObjectRadius() const;
};

/// The levels of each factor of the sweep, the cheapest first.
struct ExtremeLevels
{
    std::vector<double> depthRatios{1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    std::vector<double> widths{8.0,
                               0.0,
                               0.25,
                               1.0,
                               64.0,
                               1e4,
                               std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()};
    std::vector<glm::ivec2> sizes{{96, 64}, {1, 1}, {3, 7}, {1919, 1079}, {3840, 2160}};
    std::vector<double> fieldsOfView{60.0, 1.0, 170.0};
    std::vector<double> scales{1.0, 1e-6, 1e-3, 1e3, 1e6}; ///< besides mirrored and singular
    std::vector<int> samples{1, 4};
    std::vector<ExtremeView> views{ExtremeView::Perspective, ExtremeView::Orthographic,
                                   ExtremeView::Oblique};
    std::vector<bool> standardZ{false, true};
    std::vector<Untidiness> meshes{Untidiness::None,       Untidiness::TurnedAtRandom,
                                   Untidiness::Doubled,    Untidiness::DoubleSided,
                                   Untidiness::TwoObjects, Untidiness::Soup,
                                   Untidiness::TJunctions, Untidiness::Open};

    std::vector<int> Counts() const; ///< the number of levels of each factor
    ExtremeCase At(const Combination& combination) const;
    /// Returns whether a sweep of all combinations tries this one; see SweepSize::Full.
    bool IsWorthIt(const Combination& combination) const;
};

} // namespace limn::study

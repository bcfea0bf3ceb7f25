#pragma once

#include "report/extremes/Pairwise.h"
#include "report/measure/Study.h"
#include "report/measure/StudyScene.h"
#include "report/measure/Techniques.h"
#include "report/measure/UntidyMesh.h"

#include <span>

namespace limn::study
{

/// A camera's way of projecting.
enum class ExtremeView
{
    Perspective,
    Orthographic,
    /// Perspective, off-centre, with a near plane that leans (Camera::projectionMatrix).
    Oblique
};

/// What is done to the outlined object's size.
enum class ExtremeScale
{
    Uniform,  ///< by ExtremeCase::scale, the camera's distance as well
    Mirrored, ///< (-1, 1, 1)
    Singular  ///< (1, 0, 1): flat, its matrix has no inverse
};

/// Limits of a picture, of which each by itself is harmless: what goes wrong does so where two
/// meet.
struct ExtremeCase
{
    double depthRatio = 1e2;   ///< far plane / near plane; the object is in the geometric middle
    double width = 8.0;        ///< pixels; may be infinite or NaN
    glm::ivec2 size{96, 64};   ///< of the picture, pixels
    double fieldOfView = 60.0; ///< degrees; of no meaning for ExtremeView::Orthographic
    ExtremeScale scaling = ExtremeScale::Uniform;
    double scale = 1.0;
    int samples = 1; ///< a pixel
    ExtremeView view = ExtremeView::Perspective;
    bool isStandardZ = false;                 ///< see ShaderCompilerOptions::usesReversedZBuffer
    Untidiness untidiness = Untidiness::None; ///< of the object's mesh

    /// Everything but width and size, readable and always the same:
    /// "ratio=1e+02 fov=60 scale=mirrored samples=4 view=oblique z=reversed mesh=soup".
    std::string Variant() const;
    /// The case that a cell's name says.
    /// @throws ContractError if its variant is not of Variant()
    static ExtremeCase OfCell(const CellId& cell);

    /// A torus, black unless `isGrey`, in the rendering layer k_OutlinedLayer before nothing; no
    /// more than 120 pixels large, however large the picture.
    SceneAsset Scene(AssetContext& assets, bool isGrey) const;
    /// Half of the object's size in Scene, pixels; less where perspective makes it so.
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
    std::vector<double> scales{1.0, 1e-6, 1e-3, 1e3, 1e6}; ///< beside them mirrored and singular
    std::vector<int> samples{1, 4};
    std::vector<ExtremeView> views{ExtremeView::Perspective, ExtremeView::Orthographic,
                                   ExtremeView::Oblique};
    std::vector<bool> standardZ{false, true};
    std::vector<Untidiness> meshes{Untidiness::None,       Untidiness::TurnedAtRandom,
                                   Untidiness::Doubled,    Untidiness::DoubleSided,
                                   Untidiness::TwoObjects, Untidiness::Soup,
                                   Untidiness::TJunctions, Untidiness::Open};

    std::vector<int> Counts() const; ///< of each factor
    ExtremeCase At(const Combination& combination) const;
    /// For a sweep of all combinations: see SweepSize::Full.
    bool IsWorthIt(const Combination& combination) const;
};

} // namespace limn::study

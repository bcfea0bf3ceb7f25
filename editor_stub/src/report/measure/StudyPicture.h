#pragma once

#include "report/measure/Study.h"
#include "report/truth/OutlineReference.h"
#include "scene/SceneView.h"

namespace limn::study
{

/// Draws a scene again and again, and returns its pictures as numbers.
class StudyPicture
{
public:
    /// @param asset   the scene after UseTechnique; its features are created here
    /// @param assets, device  must outlive this
    StudyPicture(SceneAsset asset, const AssetContext& assets, GraphicsDevice& device);

    SceneAsset& asset() { return m_View.asset(); } ///< without its features
    double time = 0.0;                             ///< in seconds, the _Time of the next frame

    /// Draws a frame.
    /// @param timeline  receives the times of the phases; may be null
    const RenderResult& Render(Timeline* timeline = nullptr);
    /// Draws a frame and returns the camera's colour before it is rounded to 8 bits:
    /// R16G16B16A16_SFloat if the camera allows HDR.
    Image Colors();
    /// Draws a frame and returns the first channel of Colors(), linear.
    Coverage Alpha();
    /// Draws a frame and returns what a person sees, in R8G8B8A8_SRGB.
    Image Output();

private:
    GraphicsDevice& m_Device;
    UniversalRenderPipeline m_Pipeline;
    SceneView m_View;
    RenderRequest m_Request;
    RenderResult m_Result;
};

/// A square of a picture, enlarged for people to look at.
struct PictureWindow
{
    int x = 0;
    int y = 0;
    int side = 64;
    int scale = 4; ///< a pixel becomes scale x scale pixels
};

/// Returns the window around the place on the silhouette's border that is nearest to the picture's
/// upper left corner. It is the same for all techniques.
PictureWindow WindowOnBorder(const Silhouette& silhouette, int width, int height);

/// Returns alpha as shades of grey, not encoded as sRGB.
Image AlphaImage(const Coverage& alpha, const PictureWindow& window);
/// Returns an image that is white where the two agree, red where too much is drawn, and blue where
/// too little is drawn.
Image DifferenceImage(const Coverage& alpha, const Coverage& exact, const PictureWindow& window);

/// Writes a picture of a cell below the study's folder.
/// @returns the picture's name, relative to the folder
std::string WriteStudyPicture(const Image& image, const std::filesystem::path& folder,
                              const CellId& id, const std::string& what);
/// Returns the window around the same place in a picture for people, in which an outline of the
/// given width is seen as a whole.
/// @param renderedPixel  how many pixels of the picture are one of `window` (renderScale)
PictureWindow CloseUp(const PictureWindow& window, double width, double renderedPixel);
/// Returns the window's part of an R8G8B8A8 image, opaque. Where the window reaches beyond the
/// image it is moved, and if it is larger than the image it is cut.
Image EnlargedPart(const Image& image, const PictureWindow& window);
/// Returns the part of the whole scene that has the outline.
Image ScenePart(const Image& image, const Box& bounds, double width);

} // namespace limn::study

#pragma once

#include "report/measure/Study.h"
#include "report/truth/OutlineReference.h"

#include <filesystem>
#include <limn/core/Image.h>

namespace limn::study
{

/// A square of a picture, for people to look at.
struct PictureWindow
{
    int x = 0;
    int y = 0;
    int side = 64;
    int scale = 4; ///< a pixel becomes so many
};

/// Around the place on the silhouette's border that is nearest to the picture's upper left corner:
/// the same for all techniques.
PictureWindow WindowOnBorder(const Silhouette& silhouette, int width, int height);

/// Alpha as a shade of grey, not encoded as sRGB.
Image AlphaImage(const Coverage& alpha, const PictureWindow& window);
/// White where they agree, red where too much is drawn, blue where too little.
Image DifferenceImage(const Coverage& alpha, const Coverage& exact, const PictureWindow& window);

/// Writes a picture of a cell below the study's folder.
/// @returns its name, relative to the folder
std::string WriteStudyPicture(const Image& image, const std::filesystem::path& folder,
                              const CellId& id, const std::string& what);
/// The same of the part of the whole scene that the outline is in.
std::string WriteScenePicture(const Image& image, const Box& bounds, double width,
                              const std::filesystem::path& folder, const CellId& id);

} // namespace limn::study

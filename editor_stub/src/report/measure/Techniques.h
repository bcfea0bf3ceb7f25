#pragma once

#include "report/measure/Study.h"
#include "report/truth/SeenOutline.h"

#include <limn/editor_stub/SceneFile.h>
#include <optional>

namespace limn::study
{

/// The rendering layer that the outlined objects of a study are in, and no others.
inline constexpr int k_OutlinedLayer = 31;

/// An outline technique as a study draws it: a renderer feature called "Outline", and what is set
/// of it and of its volume component, as `limn render --set` takes it.
struct Technique
{
    TechniqueInfo info;
    std::string component;            ///< the volume component's type
    std::vector<std::string> changes; ///< "Outline.m_Method=Separable"
    /// The widest outline it can draw, pixels; infinite where nothing limits it.
    double widestOutline = std::numeric_limits<double>::infinity();
    /// The place at which what stands in front hides its outline; none if it is drawn over that.
    std::optional<HiddenAt> hiddenAt = std::nullopt;
    /// The setting, "Outline.m_Occlusion", that makes it draw the Visible or the Hidden part of the
    /// outline, which HiddenAt::Border divides; "" if there is none.
    std::string occlusion = "";
};

/// All techniques that come with limn, each with the settings that bring it nearest to a line of
/// the asked width around the outside of every outlined object, over everything in front of it if
/// they can.
const std::vector<Technique>& Techniques();
/// Null for an unknown name; lower and upper case are the same.
const Technique* FindTechnique(std::string_view name);

/// Makes a white outline of that width the scene's only feature and removes its volumes.
/// @param width  pixels, as a person would type it: "nan" is refused, as it would be there
/// @throws AssetError if the feature or its component refuses the width
void UseTechnique(SceneAsset& asset, const Technique& technique, const std::string& width,
                  AssetContext& assets);
void UseTechnique(SceneAsset& asset, const Technique& technique, double width,
                  AssetContext& assets);

} // namespace limn::study

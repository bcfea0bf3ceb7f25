#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// The place at which an outline technique asks whether something stands in front of the object.
/// How near the object is there is always its own nearness at the nearest point of its border.
enum class HiddenAt
{
    Border, ///< at that point of the border: the outline ends where the border's visible part ends
    Point   ///< at the outline's own point, as the depth test of a hull does
};

/// An outline technique: how people read of it, and how a line of an asked width around the outside
/// of every outlined object, over everything in front of it, is drawn with it. A feature that draws
/// outlines gives its techniques to FeatureRegistry::Register.
struct Technique
{
    std::string name = {};      ///< "Jump flood"
    std::string feature = {};   ///< the feature's type, filled in by FeatureRegistry::Register
    std::string summary = {};   ///< one line for people
    bool isArticle = false;     ///< an article's own formula, kept with its flaws
    std::string noWidth = {};   ///< why there is no width in pixels to hold it to; "" if there is
    int place = 1000;           ///< in tables: techniques of smaller numbers stand before it
    std::string component = {}; ///< the volume component's type
    /// What brings it nearest to such a line, as `limn render --set` takes it; the feature is
    /// called "Outline": "Outline.m_Method=Separable".
    std::vector<std::string> settings = {};
    /// The widest outline it can draw, pixels; infinite where nothing limits it.
    double widestOutline = std::numeric_limits<double>::infinity();
    /// The place at which what stands in front hides its outline; none if it is drawn over that.
    std::optional<HiddenAt> hiddenAt = std::nullopt;
    /// The setting, "Outline.m_Occlusion", that makes it draw the Visible or the Hidden part of the
    /// outline, which HiddenAt::Border divides; "" if there is none.
    std::string occlusion = {};
};

} // namespace limn

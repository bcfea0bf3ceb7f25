#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// The place at which an outline technique tests whether something stands in front of the object.
/// At either place the object's depth is its own depth at the nearest point of its border.
enum class HiddenAt
{
    /// The nearest point of the border: the outline ends where the border's visible part ends.
    Border,
    Point ///< the outline's own point, as in the depth test of a hull
};

/// An outline technique: its description for people, and the settings with which it draws a line of
/// a given width around the outside of every outlined object, over everything in front of it. A
/// feature that draws outlines gives its techniques to FeatureRegistry::Register.
struct Technique
{
    std::string name = {};      ///< "Jump flood"
    std::string feature = {};   ///< the feature's type, filled in by FeatureRegistry::Register
    std::string summary = {};   ///< one line for people
    bool isArticle = false;     ///< an article's own formula, kept with its flaws
    std::string noWidth = {};   ///< why it has no exact width in pixels; "" if it has one
    int place = 1000;           ///< its place in tables: techniques with smaller numbers come first
    std::string component = {}; ///< the volume component's type
    /// The settings that bring it nearest to such a line, as `limn render --set` takes them. The
    /// feature is called "Outline": "Outline.m_Method=Separable".
    std::vector<std::string> settings = {};
    /// The widest outline it can draw, in pixels; infinite if there is no limit.
    double widestOutline = std::numeric_limits<double>::infinity();
    /// The place at which objects in front hide its outline; nullopt if the outline is drawn over
    /// them.
    std::optional<HiddenAt> hiddenAt = std::nullopt;
    /// The setting, "Outline.m_Occlusion", that makes it draw the Visible or the Hidden part of the
    /// outline, which HiddenAt::Border divides; "" if there is none.
    std::string occlusion = {};
};

} // namespace limn

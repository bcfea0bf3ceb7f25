#pragma once

#include <limn/core/Inspector.h>
#include <limn/editor_stub/SceneFile.h>
#include <optional>
#include <span>
#include <string>

namespace limn
{

/// A step of a selection: --select, --click or --ctrl-click.
struct SelectionStep
{
    enum class Kind
    {
        Select,
        Click,
        CtrlClick
    };

    Kind kind = Kind::Select;
    std::string text; ///< names of objects, or a click as ParseClick takes it
};

/// A parsed click: "X,Y" or "X,Y@SECONDS".
struct ClickText
{
    int x = 0; ///< from the left of the picture
    int y = 0; ///< from its top
    double time = 0.0;
};

/// Returns the click, or nothing if the text is none.
std::optional<ClickText> ParseClick(const std::string& text);
/// Returns what is wrong with the click's place in a picture of this size, or "" if nothing is.
std::string PixelProblem(const ClickText& click, int width, int height);

/// Finds the objects that a feature draws, as far as its settings tell: those of rendering layers,
/// in layers and in render queues.
class FilterFinder final : public Inspector
{
public:
    /// @param needsNames  settings count only if they have the names that outline features give
    /// them
    explicit FilterFinder(ScriptableRendererFeature& feature, bool needsNames = false);
    void Field(const FieldInfo& field, FieldValue value) override;

    bool hasRenderingLayers = false; ///< true if there is a setting for them
    FilteringSettings filter;

private:
    bool m_NeedsNames;
};

/// Does the steps one after another. Objects that are selected at the end are in the rendering
/// layers by which the scene's features recognise selected objects, and in `asset.selected`. A
/// click that hits nothing that can be selected becomes a note with the reason.
/// @throws AssetError if no object has a given name, if a pixel is outside of the picture, or if no
///     feature would show a selection
void ApplySelection(SceneAsset& asset, std::span<const SelectionStep> steps);

} // namespace limn

#pragma once

#include <limn/editor_stub/Raycast.h>
#include <span>
#include <vector>

namespace limn
{

/// An object that a person chose, with all that hangs below it.
struct Selected
{
    GameObject* object = nullptr; ///< never null
    double time = 0.0;            ///< when it was selected, in seconds

    bool operator==(const Selected&) const = default;
};

/// The object that a click on a part of a whole selects.
enum class SelectUnit
{
    Whole, ///< the topmost object that the part hangs below
    Part   ///< the part itself
};

struct SelectSettings
{
    /// Marks the selected objects: their renderers are in these rendering layers, all others are
    /// not.
    RenderingLayerMask renderingLayers;
    SelectUnit unit = SelectUnit::Whole;
    /// The objects that a click can hit, and that hide what is behind them. Objects outside of the
    /// camera's culling mask or its clip planes are never hit.
    RaycastSettings raycast;
    /// A click on an object in none of these layers counts as a click on nothing, as on the
    /// article's ground, though the object hides what is behind it.
    LayerMask selectableLayers = LayerMask::Everything();
};

/// Selects objects of a scene by clicks, as Unity's editor does. A click selects the object that is
/// seen there and nothing else. A click with Ctrl adds the object or takes it away. A click on
/// nothing, with or without Ctrl, leaves nothing selected.
/// @source SelectController of the article on outlines of selected objects (Unity)
class SelectController
{
public:
    /// Selects what the scene already has in the rendering layers, since time 0: the topmost
    /// objects whose renderers are all in them.
    /// @lifetime  keeps `scene` by reference
    SelectController(Scene& scene, SelectSettings settings);

    /// Handles a click on an object that GetHitObj returned, or on nothing if `hit` is null.
    void Click(GameObject* hit, bool isCtrl, double time);
    /// Returns the object that a click on this pixel would select, or null if it would select none.
    /// @param x, y  the column and the row from the top left of the picture
    /// @throws ContractError as PixelToRay
    GameObject* GetHitObj(const Camera& camera, int width, int height, int x, int y);
    /// Returns what is seen at this pixel, even if it cannot be selected.
    std::optional<RaycastHit> Raycast(const Camera& camera, int width, int height, int x, int y);

    /// Selects exactly these objects, each once. Those that were selected already keep their time.
    void Select(std::span<GameObject* const> objects, double time);

    /// Returns the selected objects in the order in which they were selected. An object that a
    /// click without Ctrl selects again keeps its time. An object that was not selected meanwhile
    /// has a new one.
    const std::vector<Selected>& selected() const { return m_Targets; }

private:
    GameObject* WholeOf(GameObject& part) const;
    void AdoptMarked();
    void DrawOutline();

    Scene& m_Scene;
    SelectSettings m_Settings;
    Raycaster m_Raycaster;
    std::vector<Selected> m_Targets;
};

} // namespace limn

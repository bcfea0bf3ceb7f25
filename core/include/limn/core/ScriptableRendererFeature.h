#pragma once

#include <limn/core/RenderingData.h>
#include <string>

namespace limn
{

class Inspector;

/// An effect added to a renderer: makes its passes once, offers them each frame.
/// Unity: UnityEngine.Rendering.Universal.ScriptableRendererFeature (URP 14).
class ScriptableRendererFeature
{
public:
    ScriptableRendererFeature() = default;
    virtual ~ScriptableRendererFeature() = default;
    ScriptableRendererFeature(const ScriptableRendererFeature&) = delete;
    ScriptableRendererFeature& operator=(const ScriptableRendererFeature&) = delete;

    std::string name; ///< as the user calls it; reports use it

    /// Makes the passes. Called after the settings were filled in, and again after they changed: it
    /// replaces what it made before.
    virtual void Create() = 0;
    /// Once a camera a frame, while active: enqueue passes. Camera targets do not exist yet.
    virtual void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) = 0;
    /// Once a camera a frame, while active, when the camera's targets exist; not for
    /// CameraType::Preview.
    virtual void SetupRenderPasses(ScriptableRenderer& renderer,
                                   const RenderingData& renderingData);

    /// How far outside of the picture objects lie that this feature still wants among the culling
    /// results, pixels; not negative. Asked before culling, while active.
    virtual float cullingMargin(const VolumeStackPointer& volumeStack) const;

    /// Names every setting to `inspector`, which reads or writes them.
    virtual void Describe(Inspector& inspector);

    bool isActive() const { return m_Active; }
    /// Only a flag: an inactive feature keeps what it made.
    void SetActive(bool active) { m_Active = active; }

    /// Once, by the renderer that it was added to, before it is destroyed with that.
    void Dispose() { Dispose(true); }

protected:
    /// What of the feature destructors do not let go of. What it throws is lost.
    /// @param disposing  true
    virtual void Dispose(bool disposing);

private:
    bool m_Active = true;
};

} // namespace limn

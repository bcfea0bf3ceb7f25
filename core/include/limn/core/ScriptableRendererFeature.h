#pragma once

#include <limn/core/RenderingData.h>
#include <string>

namespace limn
{

class Inspector;

/// An effect that is added to a renderer: it makes its passes once and enqueues them each frame.
/// Unity: UnityEngine.Rendering.Universal.ScriptableRendererFeature (URP 14).
class ScriptableRendererFeature
{
public:
    ScriptableRendererFeature() = default;
    virtual ~ScriptableRendererFeature() = default;
    ScriptableRendererFeature(const ScriptableRendererFeature&) = delete;
    ScriptableRendererFeature& operator=(const ScriptableRendererFeature&) = delete;

    std::string name; ///< the user's name for it; reports use it

    /// Makes the passes. It is called after the settings were filled in, and again after they
    /// changed: it replaces what it made before.
    virtual void Create() = 0;
    /// Enqueues passes. It is called once per camera and frame, while active. Camera targets do not
    /// exist yet.
    virtual void AddRenderPasses(ScriptableRenderer& renderer, RenderingData& renderingData) = 0;
    /// Sets passes up when the camera's targets exist. It is called once per camera and frame,
    /// while active, but not for CameraType::Preview.
    virtual void SetupRenderPasses(ScriptableRenderer& renderer,
                                   const RenderingData& renderingData);

    /// Returns how far outside of the picture objects may lie that this feature still needs among
    /// the culling results, in pixels; must not be negative. It is called before culling, while
    /// active.
    virtual float cullingMargin(const VolumeStackPointer& /*volumeStack*/) const { return 0.0f; }

    /// Describes every setting to `inspector`, which reads or writes it.
    virtual void Describe(Inspector& /*inspector*/) {}

    bool isActive() const { return m_Active; }
    /// Sets a flag only: an inactive feature keeps what it made.
    void SetActive(bool active) { m_Active = active; }

    /// Disposes of the feature. The renderer that it was added to calls it once, before it is
    /// destroyed with that.
    void Dispose() { Dispose(true); }

protected:
    /// Releases what destructors do not. The argument is true, as in Unity. What the function
    /// throws is lost.
    virtual void Dispose(bool /*disposing*/) {}

private:
    bool m_Active = true;
};

} // namespace limn

#pragma once

namespace limn
{

/// What a volume component of a visual effect answers before its pass is added.
/// Unity: UnityEngine.Rendering.Universal.IPostProcessComponent (URP 14).
class IPostProcessComponent
{
public:
    virtual ~IPostProcessComponent() = default;

    virtual bool IsActive() const = 0; ///< whether the effect shows with the current values
    virtual bool IsTileCompatible() const = 0;
};

} // namespace limn

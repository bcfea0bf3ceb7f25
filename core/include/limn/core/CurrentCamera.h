#pragma once

namespace limn
{

struct RenderingData;

/// The camera that this thread renders. Helpers that are given no RenderingData find it here, where
/// Unity uses a singleton. The pipeline makes one for each camera.
class CurrentCamera
{
public:
    /// @param data  must outlive this
    explicit CurrentCamera(const RenderingData& data);
    ~CurrentCamera();
    CurrentCamera(const CurrentCamera&) = delete;
    CurrentCamera& operator=(const CurrentCamera&) = delete;

    /// Returns the data of the camera that is rendered, or null if none is.
    static const RenderingData* renderingData();

    /// Returns the same data.
    /// @throws ContractError if this thread renders no camera
    static const RenderingData& Rendered();

private:
    const RenderingData* m_Before;
};

/// The size of the picture that this thread renders, in pixels. Unity: UnityEngine.Screen, whose
/// size is that of the window.
namespace Screen
{

/// @throws ContractError if this thread renders no camera
int width();
/// @throws ContractError if this thread renders no camera
int height();

} // namespace Screen

} // namespace limn

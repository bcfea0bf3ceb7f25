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

private:
    const RenderingData* m_Before;
};

} // namespace limn

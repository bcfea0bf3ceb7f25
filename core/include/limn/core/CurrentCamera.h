#pragma once

namespace limn
{

struct RenderingData;

/// The camera that this thread renders, for what Unity reaches by a singleton: helpers that are
/// given no RenderingData. The pipeline makes one for each camera.
class CurrentCamera
{
public:
    /// @param data  must outlive this
    explicit CurrentCamera(const RenderingData& data);
    ~CurrentCamera();
    CurrentCamera(const CurrentCamera&) = delete;
    CurrentCamera& operator=(const CurrentCamera&) = delete;

    /// Null where no camera is rendered.
    static const RenderingData* renderingData();

private:
    const RenderingData* m_Before;
};

} // namespace limn

#pragma once

#include <gtest/gtest.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>

#include "scene/TestScene.h"

namespace limn::test
{

/// A scene and a camera that a pipeline renders into a picture of its own.
template <class Device = RecordingDevice>
class PipelineTest : public testing::Test
{
protected:
    PipelineTest(int width, int height)
    {
        m_Request.scene = &m_Scene;
        m_Request.camera = &m_Camera;
        m_Request.width = width;
        m_Request.height = height;
    }

    RenderResult Render() { return m_Pipeline.RenderSingleCamera(m_Renderer, m_Request); }

    Device m_Device;
    UniversalRenderPipeline m_Pipeline{m_Device};
    UniversalRenderer m_Renderer{Compiler()};
    Scene m_Scene;
    Camera m_Camera;
    RenderRequest m_Request;
};

} // namespace limn::test

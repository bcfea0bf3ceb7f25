#include <limn/core/CurrentCamera.h>

#include <limn/base/Diagnostic.h>
#include <limn/core/RenderingData.h>
#include <utility>

namespace limn
{

namespace
{

thread_local const RenderingData* t_Current = nullptr;

} // namespace

CurrentCamera::CurrentCamera(const RenderingData& data) : m_Before(std::exchange(t_Current, &data))
{
}

CurrentCamera::~CurrentCamera()
{
    t_Current = m_Before;
}

const RenderingData* CurrentCamera::renderingData()
{
    return t_Current;
}

const RenderingData& CurrentCamera::Rendered()
{
    if (t_Current == nullptr)
    {
        throw ContractError("no camera is rendered here, so there is no size of a picture and no "
                            "projection; ask for them in a method that limn calls in each frame");
    }
    return *t_Current;
}

int Screen::width()
{
    return CurrentCamera::Rendered().cameraData.cameraTargetDescriptor.width;
}

int Screen::height()
{
    return CurrentCamera::Rendered().cameraData.cameraTargetDescriptor.height;
}

} // namespace limn

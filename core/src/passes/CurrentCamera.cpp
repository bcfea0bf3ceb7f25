#include <limn/core/CurrentCamera.h>

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

} // namespace limn

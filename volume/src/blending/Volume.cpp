#include <limn/volume/Volume.h>

namespace limn
{

VolumeProfile& Volume::profile(const VolumeComponentRegistry& registry)
{
    if (!m_Profile)
    {
        m_Profile = std::make_shared<VolumeProfile>(sharedProfile ? sharedProfile->Clone(registry)
                                                                  : VolumeProfile());
    }
    return *m_Profile;
}

} // namespace limn

#pragma once

namespace limn
{

/// What a curve does outside its keys. Unity: UnityEngine.WrapMode (2022.3).
enum class WrapMode
{
    Default = 0, ///< of a curve: as ClampForever
    Once = 1,    ///< of a curve: as ClampForever
    Clamp = 1,
    Loop = 2,        ///< begins again
    PingPong = 4,    ///< runs back and forth
    ClampForever = 8 ///< stays at the value of the key at the end
};

} // namespace limn

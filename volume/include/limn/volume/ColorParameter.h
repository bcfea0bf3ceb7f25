#pragma once

#include <limn/core/Color.h>
#include <limn/volume/ValueParameter.h>

namespace limn
{

namespace detail
{

/// What an editor offers for a colour; blending and files do not look at it.
template <typename Base>
class ColorHints : public Base
{
public:
    using Base::Base;

    ColorHints(VolumeComponent* owner, std::string_view name, const Color& value, bool hdrColor,
               bool showAlphaChannel, bool showPicker, bool overrideState = false,
               ParameterInfo info = {})
        : Base(owner, name, value, overrideState, std::move(info)),
          hdr(hdrColor),
          showAlpha(showAlphaChannel),
          showEyeDropper(showPicker)
    {
    }

    const bool hdr = false;           ///< channels above 1 make sense
    const bool showAlpha = true;      ///< alpha makes sense
    const bool showEyeDropper = true; ///< may be picked from the screen
};

} // namespace detail

/// A colour, blended linearly per channel, alpha too, in whatever space its values are in.
/// Unity: ColorParameter (URP 14).
class ColorParameter : public detail::ColorHints<detail::LerpParameter<Color>>
{
public:
    using ColorHints::ColorHints;
    std::string_view typeName() const override { return "Color"; }
};

/// A colour; blending switches as soon as t > 0. Unity: NoInterpColorParameter (URP 14).
class NoInterpColorParameter : public detail::ColorHints<detail::ValueParameter<Color>>
{
public:
    using ColorHints::ColorHints;
    std::string_view typeName() const override { return "NoInterpColor"; }
};

} // namespace limn

#pragma once

#include "report/truth/twins/Field.h"

namespace limn::test
{

using study::Compare;
using study::CompositeReference;
using study::Difference;
using study::Field;
using study::QuantiseToR8;
using study::RobertsReference;
using study::ToField;

} // namespace limn::test

#pragma once

#include "values/Snippet.h"

// What operators and functions of the language give, worked out in double. Every value must be
// exact in the fewest bits that its type may have, so that nothing is ever rounded and there is
// nothing to tolerate.

namespace limn::test::snippets
{

/// Cuts a whole number to what an integer holds, and requires of other numbers that they are held.
double Fit(Scalar scalar, double x);
double Convert(Scalar from, Scalar to, double x);
Numbers Convert(const Type& from, const Type& to, const Numbers& numbers);
/// An operator's value; the operands become what they have in common before.
Numbers Calculate(const std::string& op, const Type& left, const Numbers& x, const Type& right,
                  const Numbers& y);
/// The value of a function of the language, of which the numbers of each argument are given.
Numbers CallIntrinsic(const Node& node, std::vector<Numbers> given);

} // namespace limn::test::snippets

// For #include_with_pragmas: no target of limn has regions of lower resolution, and so no keyword.
#pragma once

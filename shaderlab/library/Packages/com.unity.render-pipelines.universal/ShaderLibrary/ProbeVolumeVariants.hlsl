// Light probe volumes are no part of limn.
#pragma once

// Instancing by entities is no part of limn.
#pragma once

// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::behavior {

// Kinds of ground: what the building marks polygons with and ways are charged by.

constexpr unsigned short kOpen = 1; ///< flag of polygons
constexpr unsigned short kForbidden = 2;
constexpr unsigned char kPreferredArea = 1;
constexpr unsigned char kForbiddenArea = 2;
constexpr unsigned char kFirstSlowArea = 10;
constexpr int kSlowAreas = 20; ///< so many steps of slowness

} // namespace crowd::behavior

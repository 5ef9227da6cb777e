// SPDX-License-Identifier: MIT
#pragma once

namespace crowd::testing {

/// How long a script of a few lines may take, also under the sanitizers, before a test gives up.
inline constexpr int kScriptPatienceMs = 20'000;

} // namespace crowd::testing

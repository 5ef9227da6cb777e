// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace crowd::model {

/// Asked now and then by work that takes long, on the thread that does it, with the share that is
/// done, 0 to 1. False: it is to end and to take back what it did. Empty: nobody asks.
using KeepGoing = std::function<bool(double share)>;

} // namespace crowd::model

// SPDX-License-Identifier: MIT
#pragma once

namespace pybind11 {
class module_;
}

namespace crowd::app {

/// Fills the Python module crowdbrush; serves the extension module and the embedded one alike.
void registerModule(pybind11::module_& module);

} // namespace crowd::app

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <pybind11/embed.h>

namespace crowd::app {

/// The program's own Python with the module crowdbrush in it: the thread that makes it is Python's
/// main thread and holds its lock. Once in a process.
class EmbeddedPython
{
public:
    /// `handlesSignals`: Ctrl+C in a terminal raises KeyboardInterrupt; otherwise the program's
    /// handling of signals stays as it is.
    explicit EmbeddedPython(bool handlesSignals);
    ~EmbeddedPython();
    EmbeddedPython(const EmbeddedPython&) = delete;
    EmbeddedPython& operator=(const EmbeddedPython&) = delete;

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

/// Of sys.exit(value): None is success, a number is the status, anything else is printed.
[[nodiscard]] int exitStatus(const pybind11::object& code);

} // namespace crowd::app

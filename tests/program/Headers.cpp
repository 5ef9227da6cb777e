// SPDX-License-Identifier: MIT
// Compiled headers belong to what has a source of its own: those of the tests to this one.

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// Experiments of the field, repeated with our crowd: how people are known to walk, and how ours
/// do. Speeds by density and flows through doors have published limits; the limits of the lanes, of
/// the corner and of what sessions do are our own. The crowd's constants were chosen with
/// these same experiments, so the rows keep it from getting worse; they do not predict others.
namespace crowd::behavior {

struct ValidationRow
{
    std::string what;
    std::string unit;
    double measured = 0.0;
    double low = 0.0; ///< what is published with its tolerance, or our own limit
    double high = 0.0;

    /// A line of a table.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool isWithin() const { return measured >= low && measured <= high; }
};

/// Runs all of them, some seconds long; the same result every time.
[[nodiscard]] std::vector<ValidationRow> validate();

/// Speed among so many people per square metre, m/s, free speed 1.34: U. Weidmann,
/// "Transporttechnik der Fussgänger", ETH Zürich 1993.
[[nodiscard]] double weidmannSpeed(double perSquareMetre);

} // namespace crowd::behavior

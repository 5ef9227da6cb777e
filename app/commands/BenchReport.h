// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QJsonObject>

/// What every benchmark says at its end.
namespace crowd::app {

/// Three decimals.
[[nodiscard]] double rounded(double value);

/// The upper one of the middle two; `values` has one at least.
[[nodiscard]] double median(std::vector<double> values);

/// Of a steady clock.
[[nodiscard]] double nowMs();

/// To the standard output: as one line of JSON, or a line for each member.
void printReport(const QJsonObject& report, bool isJson);

} // namespace crowd::app

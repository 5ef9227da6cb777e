// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "app/python/Binding.h"
#include "app/python/ScriptPeople.h"

/// Between the population's columns and NumPy arrays.
namespace crowd::app {

/// A copy of a column for all individuals, rows by ascending id: N for numbers, N×3 float32 for
/// positions, N×4 uint8 for tint0 … tint7 (red, green, blue, strength), N×8×4 for "tint", N×8 uint8
/// for "choices". "id" is a column too. Unknown names raise.
[[nodiscard]] py::array columnArray(model::Population population, const std::string& name);

/// One value as NumPy holds it: "float32", "3 × float32".
[[nodiscard]] std::string valueTypeText(model::ColumnType type);
/// The default: a number or a list of them.
[[nodiscard]] py::object initialValue(const model::PropertyInfo& property);

/// Whatever NumPy makes an array of. Raises where it cannot, and where some of it is masked.
[[nodiscard]] py::array arrayOf(const std::string& name, const py::object& given);

/// Column values by keyword for so many individuals (nothing: as many as the longest argument).
/// One value stands for all. Clips given by name are looked up in each one's template: the one
/// given beside them, else `templates` (as long as count). Raises on unknown names, wrong shapes,
/// wrong types.
struct GivenColumns
{
    std::size_t count = 0;
    std::vector<ColumnValues> values;
};
[[nodiscard]] GivenColumns columnsFrom(const ScenePtr& scene, const py::kwargs& arguments,
                                       std::optional<std::size_t> count,
                                       std::span<const model::TemplateId> templates);

/// Ids from an array of ids or a mask over all rows; ascending. Raises on wrong types and lengths.
/// `order` gets, for each of them, its place in the argument (identity for masks).
[[nodiscard]] std::vector<model::IndividualId>
idsFrom(const ScriptScene& scene, const py::object& idsOrMask, std::vector<std::size_t>& order);

/// Brings values given in the argument's order into the order of the ascending ids.
void reorder(std::vector<ColumnValues>& values, const std::vector<std::size_t>& order);

} // namespace crowd::app

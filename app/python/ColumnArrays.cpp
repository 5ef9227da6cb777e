// SPDX-License-Identifier: MIT
#include "app/python/ColumnArrays.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

#include "app/python/ColumnRules.h"
#include "app/python/OutsidePython.h"
#include "model/brush/ClipChoice.h"

namespace crowd::app {

using namespace model;
using namespace py::literals;

py::array arrayOf(const std::string& name, const py::object& given)
{
    const bool isOddArray = py::isinstance<py::array>(given) &&
                            reinterpret_cast<PyTypeObject*>(py::type::handle_of(given).ptr()) !=
                                py::detail::npy_api::get().PyArray_Type_;
    if (isOddArray &&
        callPython(py::module_::import("numpy.ma").attr("is_masked"), py::make_tuple(given))
            .cast<bool>()) {
        throw ScriptError(name + " has masked values: fill them, as in array.filled(0), or leave "
                                 "them out, as in array.compressed().");
    }
    py::array array = py::array::ensure(given);
    if (!array) {
        PyErr_Clear();
        throw ScriptError(name + " must be a number or an array of numbers, not " + shortly(given) +
                          ".");
    }
    return array;
}

namespace {

std::string knownColumns()
{
    std::string names = "id, tint";
    for (const PropertyInfo& property : properties()) {
        names += ", " + std::string(property.column.name);
    }
    return names;
}

ColumnId columnNamed(const std::string& name)
{
    const PropertyInfo* property = findProperty(name);
    if (property == nullptr) {
        throw ScriptError("There is no column \"" + name + "\". There are: " + knownColumns() +
                          ".");
    }
    return property->id;
}

/// What a column's values look like in NumPy: an item type and how many a row.
struct RowShape
{
    py::dtype type;
    std::vector<py::ssize_t> extents; ///< of one row; empty for a number
};

RowShape shapeOf(ColumnType type)
{
    switch (type) {
    case ColumnType::Float:
        return {py::dtype::of<float>(), {}};
    case ColumnType::Vec3:
        return {py::dtype::of<float>(), {3}};
    case ColumnType::UInt16:
        return {py::dtype::of<std::uint16_t>(), {}};
    case ColumnType::UInt32:
        return {py::dtype::of<std::uint32_t>(), {}};
    case ColumnType::UInt64:
        return {py::dtype::of<std::uint64_t>(), {}};
    case ColumnType::Tint:
        return {py::dtype::of<std::uint8_t>(), {4}};
    case ColumnType::Bytes8:
        break;
    }
    return {py::dtype::of<std::uint8_t>(), {8}};
}

std::string shapeText(std::span<const py::ssize_t> extents)
{
    std::string text = "N";
    for (const py::ssize_t extent : extents) {
        text += "×" + std::to_string(extent);
    }
    return text;
}

/// NumPy lets other threads run while it copies by itself, and they may add people meanwhile.
py::array copied(const py::dtype& type, std::vector<py::ssize_t> extents,
                 std::span<const std::byte> bytes)
{
    py::array array(type, std::move(extents));
    std::ranges::copy(bytes, static_cast<std::byte*>(array.mutable_data()));
    return array;
}

py::array allTints(const Population& population)
{
    const auto n = static_cast<py::ssize_t>(population.size());
    py::array_t<std::uint8_t> tints({n, py::ssize_t{8}, py::ssize_t{4}});
    auto* to = reinterpret_cast<Tint*>(tints.mutable_data());
    for (int slot = 0; slot < 8; ++slot) {
        const auto column = population.column(columns::tint(slot));
        for (std::size_t row = 0; row < column.size(); ++row) {
            to[row * 8 + static_cast<std::size_t>(slot)] = column[row];
        }
    }
    return tints;
}

/// The argument as an array of the wanted item type, refusing what would lose something.
py::array toItems(const std::string& name, const py::object& given, const py::dtype& type)
{
    const py::array array = arrayOf(name, given);
    const char kind = array.dtype().kind();
    const bool wantsFloat = type.kind() == 'f';
    if (!(kind == 'i' || kind == 'u' || (wantsFloat && kind == 'f'))) {
        throw ScriptError(name + " must hold " +
                          (wantsFloat ? std::string("numbers") : std::string("whole numbers")) +
                          ", not " + std::string(py::str(array.dtype())) + ".");
    }
    const bool fitsAnyway = kind == 'u' && array.itemsize() <= type.itemsize();
    if (!wantsFloat && !fitsAnyway && array.size() > 0) {
        const auto low = py::int_(callPython(array.attr("min")));
        const auto high = py::int_(callPython(array.attr("max")));
        const py::int_ most(type.itemsize() == 8 ? std::numeric_limits<std::uint64_t>::max()
                                                 : (std::uint64_t{1} << (8 * type.itemsize())) - 1);
        if (low < py::int_(0) || high > most) {
            throw ScriptError(name + " must hold whole numbers from 0 to " +
                              std::string(py::repr(most)) + ".");
        }
    }
    return py::array::ensure(array.attr("astype")(type, "order"_a = "C", "copy"_a = false));
}

/// Rows of the column from an array of shape `row` (one for all) or N × `row`.
ColumnValues toColumn(ColumnId column, const std::string& name, const py::array& items,
                      const RowShape& shape, std::size_t count)
{
    const auto rowDimensions = static_cast<py::ssize_t>(shape.extents.size());
    const bool isOneForAll = items.ndim() == rowDimensions;
    bool fits = isOneForAll || items.ndim() == rowDimensions + 1;
    for (py::ssize_t d = 0; fits && d < rowDimensions; ++d) {
        fits = items.shape(items.ndim() - rowDimensions + d) ==
               shape.extents[static_cast<std::size_t>(d)];
    }
    fits = fits && (isOneForAll || items.shape(0) == static_cast<py::ssize_t>(count));
    if (!fits) {
        throw ScriptError(
            name + " has the shape " + std::string(py::str(items.attr("shape"))) + "; it must be " +
            shapeText(shape.extents) + " with N = " + std::to_string(count) +
            (shape.extents.empty() ? ", or one value for all." : ", or one such row for all."));
    }
    const std::size_t stride = columnInfo(column).stride;
    ColumnValues values{column, std::vector<std::byte>(count * stride)};
    const auto* from = static_cast<const std::byte*>(items.data());
    if (!isOneForAll && count > 0) {
        std::memcpy(values.bytes.data(), from, count * stride);
        return values;
    }
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&values.bytes[i * stride], from, stride);
    }
    return values;
}

/// The value of the clip column for a clip's name, per individual: templates differ.
std::uint16_t clipNamed(const TemplateEntry& entry, const std::string& name)
{
    const auto found = std::ranges::find(entry.clipNames, name);
    if (found == entry.clipNames.end()) {
        std::string names;
        for (const std::string& each : entry.clipNames) {
            names += (names.empty() ? "" : ", ") + each;
        }
        throw ScriptError("Template " + entry.name + " has no clip \"" + name +
                          "\". It has: " + names + ".");
    }
    return static_cast<std::uint16_t>(found - entry.clipNames.begin());
}

std::vector<TemplateId> templatesIn(const ColumnValues& values)
{
    std::vector<TemplateId> ids(values.bytes.size() / sizeof(TemplateId));
    std::ranges::copy(values.bytes, std::as_writable_bytes(std::span(ids)).begin());
    return ids;
}

ColumnValues clipsByName(const Scene& scene, const py::object& given,
                         std::span<const TemplateId> templates)
{
    std::vector<std::string> names;
    if (py::isinstance<py::str>(given)) {
        names.assign(templates.size(), given.cast<std::string>());
    } else {
        for (const py::handle each : given) {
            if (!py::isinstance<py::str>(each)) {
                throw ScriptError("clip is a clip's name or number for each, not " + shortly(each) +
                                  " among names.");
            }
            names.push_back(each.cast<std::string>());
        }
    }
    if (names.size() != templates.size()) {
        throw ScriptError("clip names " + std::to_string(names.size()) + " clips for " +
                          std::to_string(templates.size()) + " individuals.");
    }
    ColumnValues values{ColumnId::Clip,
                        std::vector<std::byte>(names.size() * sizeof(std::uint16_t))};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const TemplateEntry* entry = scene.findTemplate(templates[i]);
        if (entry == nullptr) {
            throw ScriptError("The scene has no template " + std::to_string(templates[i]) + ".");
        }
        const std::uint16_t clip = clipNamed(*entry, names[i]);
        std::memcpy(&values.bytes[i * sizeof(clip)], &clip, sizeof(clip));
    }
    return values;
}

bool isText(const py::handle& given)
{
    if (py::isinstance<py::str>(given)) {
        return true;
    }
    if (py::isinstance<py::array>(given)) {
        const auto array = py::reinterpret_borrow<py::array>(given);
        return array.dtype().kind() == 'U' && array.ndim() == 1;
    }
    return (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) &&
           py::len(given) > 0 && py::isinstance<py::str>(given.attr("__getitem__")(0));
}

bool isListOfObjects(const py::handle& given)
{
    return py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given) ||
           (py::isinstance<py::array>(given) &&
            py::reinterpret_borrow<py::array>(given).dtype().kind() == 'O' &&
            py::reinterpret_borrow<py::array>(given).ndim() == 1);
}

/// Templates are given as handles, ids, or lists of either.
py::object templateIds(const ScenePtr& scene, const py::object& given)
{
    if (py::isinstance<TemplateHandle>(given)) {
        return py::int_(templateIdOf(scene, given));
    }
    if (isListOfObjects(given)) {
        py::list ids;
        for (const py::handle each : given) {
            ids.append(py::int_(templateIdOf(scene, each)));
        }
        return ids;
    }
    return given;
}

/// "tint": a colour, 8×4, N×8×4; a colour (3 or 4 numbers) goes to all slots.
void addTints(const py::object& given, std::size_t count, std::vector<ColumnValues>& values)
{
    py::array items = toItems("tint", given, py::dtype::of<std::uint8_t>());
    if (items.ndim() == 1 && (items.shape(0) == 3 || items.shape(0) == 4)) {
        py::array_t<std::uint8_t> all({8, 4});
        for (int slot = 0; slot < 8; ++slot) {
            for (int k = 0; k < 4; ++k) {
                const auto* from = static_cast<const std::uint8_t*>(items.data());
                *all.mutable_data(slot, k) = k < items.shape(0) ? from[k] : std::uint8_t{255};
            }
        }
        items = all;
    }
    const RowShape shape{py::dtype::of<std::uint8_t>(), {8, 4}};
    const auto n = static_cast<py::ssize_t>(count);
    const bool isOneForAll = items.ndim() == 2 && items.shape(0) == 8 && items.shape(1) == 4;
    const bool isEach =
        items.ndim() == 3 && items.shape(0) == n && items.shape(1) == 8 && items.shape(2) == 4;
    if (!isOneForAll && !isEach) {
        throw ScriptError("tint has the shape " + std::string(py::str(items.attr("shape"))) +
                          "; it must be N×8×4 with N = " + std::to_string(count) +
                          ", 8×4, or one colour of 3 or 4 numbers.");
    }
    const auto* from = static_cast<const Tint*>(items.data());
    for (std::size_t slot = 0; slot < 8; ++slot) {
        ColumnValues column{columns::tint(static_cast<int>(slot)).id,
                            std::vector<std::byte>(count * sizeof(Tint))};
        for (std::size_t i = 0; i < count; ++i) {
            std::memcpy(&column.bytes[i * sizeof(Tint)], &from[(isEach ? i * 8 : 0) + slot],
                        sizeof(Tint));
        }
        values.push_back(std::move(column));
    }
}

/// How many rows an argument speaks for; nothing: one value for all.
std::optional<std::size_t> rowsIn(const std::string& name, const py::object& given)
{
    if (py::isinstance<TemplateHandle>(given) || py::isinstance<py::str>(given)) {
        return std::nullopt;
    }
    const auto dimensions = static_cast<std::size_t>(
        name == "tint" ? 2 : shapeOf(columnInfo(columnNamed(name)).type).extents.size());
    if (isText(given) || (name == "template" && isListOfObjects(given))) {
        return py::len(given);
    }
    const py::array array = arrayOf(name, given);
    if (static_cast<std::size_t>(array.ndim()) <= dimensions) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(array.shape(0));
}

} // namespace

// The population by value: making an array may run any code, which may edit the scene.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
py::array columnArray(Population population, const std::string& name)
{
    if (name == "id") {
        return copied(py::dtype::of<IndividualId>(), {static_cast<py::ssize_t>(population.size())},
                      std::as_bytes(population.ids()));
    }
    if (name == "tint") {
        return allTints(population);
    }
    const ColumnId column = columnNamed(name);
    const RowShape shape = shapeOf(columnInfo(column).type);
    std::vector<py::ssize_t> extents{static_cast<py::ssize_t>(population.size())};
    extents.insert(extents.end(), shape.extents.begin(), shape.extents.end());
    return copied(shape.type, std::move(extents), population.columnBytes(column));
}

std::string valueTypeText(ColumnType type)
{
    const RowShape shape = shapeOf(type);
    const auto item = shape.type.attr("name").cast<std::string>();
    return shape.extents.empty() ? item : std::to_string(shape.extents.front()) + " × " + item;
}

py::object initialValue(const PropertyInfo& property)
{
    const RowShape shape = shapeOf(property.column.type);
    const auto bytes = std::span(property.initial).first(property.column.stride);
    return copied(shape.type, shape.extents, bytes).attr("tolist")();
}

namespace {

struct GivenArguments
{
    std::vector<std::pair<std::string, py::object>> byName; ///< templates first
    std::size_t rows = 1;                                   ///< of the longest
    bool hasEmpty = false;
};

/// Refuses what has more rows than a scene has room for before so much is converted.
GivenArguments argumentsFrom(const py::kwargs& arguments)
{
    GivenArguments given;
    for (const auto& [key, value] : arguments) {
        const auto name = key.cast<std::string>();
        const auto object = py::reinterpret_borrow<py::object>(value);
        const std::size_t rows = rowsIn(name, object).value_or(1);
        if (rows > kMostPeople) {
            throw ScriptError(name + " has " + std::to_string(rows) +
                              " rows; a scene has room "
                              "for " +
                              std::to_string(kMostPeople) + " characters.");
        }
        given.rows = std::max(given.rows, rows);
        given.hasEmpty |= rows == 0;
        given.byName.emplace_back(name, object);
    }
    // Clip names are their templates' own.
    std::stable_partition(given.byName.begin(), given.byName.end(),
                          [](const auto& item) { return item.first == "template"; });
    return given;
}

/// Clips by name: of the templates beside them, or else of those whom the individuals have.
ColumnValues clipColumn(const Scene& scene, const py::object& names, const GivenColumns& beside,
                        std::span<const TemplateId> templates)
{
    const auto given = std::ranges::find(beside.values, ColumnId::Template, &ColumnValues::column);
    const std::vector<TemplateId> theirs =
        given == beside.values.end() ? std::vector<TemplateId>(templates.begin(), templates.end())
                                     : templatesIn(*given);
    if (theirs.size() != beside.count) {
        throw ScriptError("Clips by name need the template beside them.");
    }
    return clipsByName(scene, names, theirs);
}

} // namespace

GivenColumns columnsFrom(const ScenePtr& scene, const py::kwargs& arguments,
                         std::optional<std::size_t> count, std::span<const TemplateId> templates)
{
    const GivenArguments given = argumentsFrom(arguments);
    GivenColumns columns{count.value_or(given.hasEmpty ? 0 : given.rows), {}};
    for (const auto& [name, object] : given.byName) {
        if (name == "tint") {
            addTints(object, columns.count, columns.values);
        } else if (name == "clip" && isText(object)) {
            columns.values.push_back(clipColumn(*scene->scene(), object, columns, templates));
        } else {
            const ColumnId column = columnNamed(name);
            const RowShape shape = shapeOf(columnInfo(column).type);
            const py::object plain = name == "template" ? templateIds(scene, object) : object;
            columns.values.push_back(
                toColumn(column, name, toItems(name, plain, shape.type), shape, columns.count));
        }
    }
    return columns;
}

std::vector<IndividualId> idsFrom(const ScriptScene& scene, const py::object& idsOrMask,
                                  std::vector<std::size_t>& order)
{
    const py::array array = arrayOf("ids", idsOrMask);
    if (array.ndim() > 1) {
        throw ScriptError("ids must be an array of ids, or a mask with a truth value for each "
                          "individual, not an array of shape " +
                          std::string(py::str(array.attr("shape"))) + ".");
    }
    std::vector<IndividualId> ids;
    order.clear();
    if (array.dtype().kind() == 'b') {
        const auto mask = py::array_t<bool>::ensure(array);
        const auto now = scene.scene();
        const auto all = now->population.ids();
        if (mask.ndim() != 1 || mask.shape(0) != static_cast<py::ssize_t>(all.size())) {
            throw ScriptError("The mask has " + std::to_string(mask.size()) + " values for " +
                              std::to_string(all.size()) + " individuals.");
        }
        const auto isMeant = mask.unchecked<1>();
        for (std::size_t row = 0; row < all.size(); ++row) {
            if (isMeant(static_cast<py::ssize_t>(row))) {
                ids.push_back(all[row]);
            }
        }
        order.resize(ids.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        return ids;
    }
    if (array.size() == 0) {
        return ids;
    }
    const py::array given = toItems("ids", array, py::dtype::of<IndividualId>());
    order.resize(static_cast<std::size_t>(given.size()));
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto* from = static_cast<const IndividualId*>(given.data());
    std::ranges::stable_sort(order, {}, [from](std::size_t i) { return from[i]; });
    for (const std::size_t place : order) {
        ids.push_back(from[place]);
    }
    return ids;
}

void reorder(std::vector<ColumnValues>& values, const std::vector<std::size_t>& order)
{
    for (ColumnValues& each : values) {
        const std::size_t stride = columnInfo(each.column).stride;
        std::vector<std::byte> sorted(each.bytes.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            std::memcpy(&sorted[i * stride], &each.bytes[order[i] * stride], stride);
        }
        each.bytes = std::move(sorted);
    }
}

} // namespace crowd::app

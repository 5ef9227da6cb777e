// SPDX-License-Identifier: MIT
#include "app/python/PythonBrush.h"

#include <string_view>

namespace crowd::app {

using namespace model;

namespace {

/// Calls visit(kind, part) for the settings of every kind.
template<class Brush, class Visit, std::size_t... Kinds>
void forEachPart(Brush& brush, const Visit& visit, std::index_sequence<Kinds...> /*all*/)
{
    (visit(std::integral_constant<std::size_t, Kinds>(), std::get<Kinds>(brush.parts)), ...);
}

constexpr auto kAllKinds = std::make_index_sequence<kBrushCount>();

/// What kinds have in common that keep no section of their own is what the first of them has.
void shareAttributes(const PythonBrush& brush, BrushSettings& settings)
{
    const BrushType& type = brushType(settings.kind());
    if (*type.info.scriptName != '\0') {
        return;
    }
    for (const FieldInfo& field : type.fields) {
        const FieldInfo* first = nullptr;
        // What is found is only read.
        void* object = sharedAttribute(const_cast<PythonBrush&>(brush), field.meta.key, first);
        if (object != nullptr) {
            field.set(type.editable(settings), first->get(object));
        }
    }
}

} // namespace

BrushSettings PythonBrush::settings() const
{
    BrushSettings settings = area;
    forEachPart(
        *this,
        [&](auto index, const auto& part) {
            if (static_cast<std::size_t>(kind) == index) {
                using Settings = std::variant_alternative_t<decltype(index)::value, BrushChange>;
                settings.change.emplace<Settings>(static_cast<const Settings&>(part));
            }
        },
        kAllKinds);
    shareAttributes(*this, settings);
    return settings;
}

PythonBrush PythonBrush::of(const BrushSettings& settings)
{
    PythonBrush brush;
    brush.kind = settings.kind();
    const BrushChange unused = brush.area.change;
    brush.area = settings;
    brush.area.change = unused;
    forEachPart(
        brush,
        [&](auto index, auto& part) {
            using Settings = std::variant_alternative_t<decltype(index)::value, BrushChange>;
            if (const auto* given = std::get_if<Settings>(&settings.change)) {
                static_cast<Settings&>(part) = *given;
            }
        },
        kAllKinds);
    const BrushType& type = brushType(settings.kind());
    for (const FieldInfo& field : type.fields) {
        const FieldInfo* first = nullptr;
        void* object =
            *type.info.scriptName == '\0' ? sharedAttribute(brush, field.meta.key, first) : nullptr;
        if (object != nullptr) {
            first->set(object, field.get(type.settings(settings)));
        }
    }
    return brush;
}

bool operator==(const PythonBrush& a, const PythonBrush& b)
{
    bool isSame = a.kind == b.kind && a.area == b.area;
    forEachPart(
        a,
        [&](auto index, const auto& part) {
            using Settings = std::variant_alternative_t<decltype(index)::value, BrushChange>;
            isSame = isSame && static_cast<const Settings&>(part) ==
                                   static_cast<const Settings&>(std::get<index>(b.parts));
        },
        kAllKinds);
    return isSame;
}

void* sharedAttribute(PythonBrush& brush, std::string_view key, const FieldInfo*& field)
{
    void* object = nullptr;
    forEachPart(
        brush,
        [&](auto index, auto& part) {
            using Settings = std::variant_alternative_t<decltype(index)::value, BrushChange>;
            const BrushType& type = brushType(static_cast<BrushKind>(decltype(index)::value));
            if (object != nullptr || *type.info.scriptKind == '\0' ||
                *type.info.scriptName != '\0') {
                return;
            }
            for (const FieldInfo& each : type.fields) {
                if (object == nullptr && key == each.meta.key) {
                    object = static_cast<Settings*>(&part);
                    field = &each;
                }
            }
        },
        kAllKinds);
    return object;
}

} // namespace crowd::app
